#pragma once
#include <memory>
#include <vector>

#include "bindings.h"
#include "fusee/checks/check.h"
#include "fusee/core/finding.h"
#include "fusee/pipeline/design.h"
#include "fusee/solid/part.h"
#include "fusee/spring/law.h"

/// What the functions return: shared, immutable C++ objects whose memory the arrays show.
namespace fusee::python {

/// Points of a law.
struct LawCurve {
    std::shared_ptr<const std::vector<spring::LawPoint>> rows;
};

/// A profile's springs and joint, or the refusal.
struct Design {
    std::shared_ptr<const pipeline::ResolvedDesign> value;  ///< null: refused
    core::Findings findings;
};

/// One cam of a design, as a solid.
struct PartResult {
    std::string name;                         ///< "k_se", "k_pe_mirrored"
    std::shared_ptr<const solid::Part> part;  ///< never null
    core::Findings findings;
    std::string provenance;   ///< of the design, for its files
    checks::Process process;  ///< that makes it
};

}  // namespace fusee::python
