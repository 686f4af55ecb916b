#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/gap_case/case.h"

namespace fusee::diagnosis {

struct DiagnoseOptions {
    unsigned jobs = 0;  ///< threads, 0: as many as cores; the answer is the same for any
    /// Told of each finished part: done, of how many, what. May throw to stop (core::Stopped).
    std::function<void(std::size_t, std::size_t, const std::string&)> progress;
};

/// Where model and rig part, which unmodelled effect causes it, how far the gap shrinks once it is in the model (docs/gap.md).
/// Deterministic. @throws core::InvalidInput if the case has too few rows to say anything
[[nodiscard]] Diagnosis diagnose(const gap_case::Case& gap_case, const DiagnoseOptions& options = {});

/// Is a diagnosis that was read from a file one of this case's rig? Each effect is known, stands once on a side, has a size (and further
/// parameters) within the range of its law, and its unit; each build parameter is known.
/// @param file the name used in messages. @throws core::InvalidInput naming the effect, its size and what is allowed
void require_possible(const gap_case::Case& nominal, const Diagnosis& found, const std::string& file);

/// What the model says of the measured columns at the inputs of `inputs`, row by row: the nominal rig with `found.effects` and
/// `found.build` in it (an empty Diagnosis: the nominal rig).
/// @throws core::InvalidInput naming an effect or side that the library does not know; a figure of the rig with these effects that cannot
/// be built (a friction below 0, an arm that is none); an experiment of which there is no finite prediction
[[nodiscard]] gap_case::Rows predict(const gap_case::Case& nominal, const Diagnosis& found, const gap_case::Rows& inputs);

}  // namespace fusee::diagnosis
