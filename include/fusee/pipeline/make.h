#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/core/folder.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/design_report.h"
#include "fusee/pipeline/export.h"
#include "fusee/pipeline/simulation.h"

/// Example:
/// @code
/// const profile::Profile p = profile::read_profile("profiles/pnrvsa.toml");
/// core::OutputFolder out("out/mine", {.command = "mine", .source = "profiles/pnrvsa.toml"});
/// const auto made = pipeline::make_parts(p, out);
/// if (!made) return made.refusal();  // nothing is written
/// std::cout << made->report.worst_arm_error() << '\n';  // of the files, against the law
/// out.commit();  // moves them into out/mine
/// @endcode
namespace fusee::pipeline {

struct MakeOptions {
    Via via = Via::kCgal;
    bool frame = true;                                  ///< false: a joint without, whatever the profile says
    std::function<void(const std::string&)> note = {};  ///< called when something long begins, on the caller's thread; may be empty
    std::function<void(const char*)> stage = {};        ///< called when a stage begins, kStages times, on the caller's thread; may be empty
    std::function<bool()> stop = {};                    ///< asked between the steps; may be empty. True: core::Stopped is thrown
};
inline constexpr std::size_t kStages = 5;

/// A design with its part files, and all that its reports show.
struct MadeDesign {
    ResolvedDesign resolved;
    std::optional<Simulation> simulation;  ///< none of a single spring
    DesignReport report;
};

/// One profile in, its cams out, and all that the reports show: law, arms, contours, solids, rules, files, read-back (README, "How it
/// works"). Writes the part files into `output` and does not commit it. An error among `report.all_findings()` says that a file does not
/// carry the law. Refusal: the findings, binding limits and passes; nothing is written then. @throws core::InvalidInput; core::IoError
[[nodiscard]] core::Outcome<MadeDesign> make_parts(const profile::Profile& profile, core::OutputFolder& output,
                                                   const MakeOptions& options = {});

/// The sheets to fill in that make writes: an inspection sheet for each part with the drawing's format.
[[nodiscard]] std::vector<std::string> sheets_of(const profile::Profile& profile);

/// What a table of many designs shows: parts, rules, certificates and headline, without `report.law`, `report.dead_band` and the joint, and
/// with the simulation of `headline_simulation`. The rules that need no mesh refuse a design before anything is meshed.
/// @param output none: no file is written, and there is no antagonist; else the part files go there, as with make_parts
[[nodiscard]] core::Outcome<MadeDesign> make_figures(const profile::Profile& profile, core::OutputFolder* output = nullptr);

}  // namespace fusee::pipeline
