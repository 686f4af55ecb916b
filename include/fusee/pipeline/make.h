#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "fusee/core/finding.h"
#include "fusee/pipeline/export.h"
#include "fusee/profile/profile.h"
#include "fusee/report/outlook.h"

namespace fusee::pipeline {

struct MakeOptions {
    std::filesystem::path out = "out";  ///< the design lands in out/NAME, complete or not at all
    Via via = Via::kCgal;
    std::function<void(const std::string&)> note = {};  ///< told when something long begins; may be empty; called on the caller's thread
    bool force = false;  ///< also replace another profile's files in out/NAME, and files changed since (core::OutputRun)
};

/// What became of one profile.
struct MakeResult {
    std::string name;
    bool made = false;                          ///< out/NAME is complete, and every file carries the law
    std::filesystem::path folder;               ///< empty when nothing was written
    core::Findings findings;                    ///< all of them, passes too; a refusal holds the binding limits
    std::vector<report::HeadFigure> head = {};  ///< what the user gets, with its range
    double worst_arm_error = 0.0;               ///< relative, over all files
    double dead_band_peak_deg = 0.0;            ///< exact, full width at the joint, at peak torque
    double worst_dead_band_change = 0.0;        ///< relative, of the joint as its files carry it: report::AsExported::worst_change
};

/// One profile in, two cams out: law, arms, contours, solids, rules, files, read-back, report (README, "How it works").
/// An impossible design writes nothing. @throws core::InvalidInput; core::IoError, also if out/NAME may not be written (core::OutputFolder)
[[nodiscard]] MakeResult make(const profile::Profile& profile, const MakeOptions& options = {});

}  // namespace fusee::pipeline
