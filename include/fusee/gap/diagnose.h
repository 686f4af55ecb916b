#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "fusee/gap/case.h"
#include "fusee/gap/diagnosis.h"

namespace fusee::gap {

struct DiagnoseOptions {
    unsigned jobs = 0;  ///< threads, 0: as many as cores; the answer is the same for any
    /// Told of each finished part: done, of how many, what. May throw to stop (core::Stopped).
    std::function<void(std::size_t, std::size_t, const std::string&)> progress;
};

/// Where model and rig part, which unmodelled effect causes it, how far the gap shrinks once it is in the model (docs/gap.md).
/// Deterministic. @throws core::InvalidInput if the case has too few rows to say anything
[[nodiscard]] Diagnosis diagnose(const Case& bench, const DiagnoseOptions& options = {});

/// What the model says of the measured columns at the inputs of `inputs`, row by row: the nominal rig with `found.effects` and
/// `found.build` in it (an empty Diagnosis: the nominal rig).
/// @throws core::InvalidInput naming an effect or side that the library does not know
[[nodiscard]] Rows predict(const Case& nominal, const Diagnosis& found, const Rows& inputs);

}  // namespace fusee::gap
