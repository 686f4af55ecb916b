#pragma once
#include <memory>

#include "fusee/assembly/assembly.h"
#include "fusee/pipeline/design.h"

namespace fusee::pipeline {

/// The joint that both parts belong to, judged.
struct Assembled {
    std::shared_ptr<const assembly::Assembly> assembly;  ///< null: not modelled; the findings say why
    core::Findings findings;
};
[[nodiscard]] Assembled assemble(const ResolvedDesign& design, std::shared_ptr<const solid::Part> k_se,
                                 std::shared_ptr<const solid::Part> k_pe);

}  // namespace fusee::pipeline
