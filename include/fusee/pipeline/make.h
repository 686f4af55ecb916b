#pragma once
#include <functional>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/core/output_folder.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/design_report.h"
#include "fusee/pipeline/export.h"
#include "fusee/pipeline/simulation.h"

namespace fusee::pipeline {

struct MakeOptions {
    Via via = Via::kCgal;
    /// All that the reports show; false: parts, files and headline only, without `report.law` and `report.dead_band`, and with the
    /// simulation of `headline_simulation`. Then the rules that need no mesh refuse a design before anything is meshed.
    bool reported = true;
    std::function<void(const std::string&)> note = {};  ///< called when something long begins, on the caller's thread; may be empty
    std::function<void(const char*)> stage = {};        ///< called when a stage begins, kStages times, on the caller's thread; may be empty
    std::function<bool()> stop = {};                    ///< asked between the steps; may be empty. True: core::Stopped is thrown
};
inline constexpr std::size_t kStages = 5;

/// A design with its part files, and all that its reports show.
struct MadeDesign {
    ResolvedDesign resolved;
    Simulation simulation;
    DesignReport report;
};

/// One profile in, two cams out: law, arms, contours, solids, rules, files, read-back (README, "How it works"). Writes the part files into
/// `output` and does not commit it. An error among `report.all_findings()` says that a file does not carry the law.
/// Refusal: the findings, binding limits and passes; nothing is written then. @throws core::InvalidInput; core::IoError
[[nodiscard]] core::Outcome<MadeDesign> make_parts(const profile::Profile& profile, core::OutputFolder& output,
                                                   const MakeOptions& options = {});

/// The sheets to fill in that make writes: an inspection sheet for each part with the drawing's format.
[[nodiscard]] std::vector<std::string> sheets_of(const profile::Profile& profile);

/// The same parts, rules, certificates and headline without any file, for the agonist's side; otherwise as with `reported` false.
[[nodiscard]] core::Outcome<MadeDesign> make_figures(const profile::Profile& profile);

/// Whether every file of a design carries its law.
struct Verification {
    core::Findings findings;  ///< all of them, passes too
    FileErrors file_errors;
    [[nodiscard]] bool passed() const { return !core::any_error(findings); }
};
/// `make_parts` in a temporary folder. @throws as make_parts
[[nodiscard]] Verification verify(const profile::Profile& profile);

}  // namespace fusee::pipeline
