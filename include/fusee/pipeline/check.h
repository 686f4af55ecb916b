#pragma once
#include <span>
#include <string>
#include <vector>

#include "fusee/checks/check.h"
#include "fusee/profile/profile.h"
#include "fusee/report/check.h"

namespace fusee::pipeline {

/// A profile as another process would make it. Its own process keeps every figure. Any other takes the process's defaults (docs/rules.md,
/// table 3) and a build volume of 200 x 200 x 200 mm in place of [process], and leaves out those [[limits]] whose default comes from the
/// process: they were stated for the profile's own.
struct OtherProcess {
    profile::Profile profile;
    std::string figures;  ///< whose figures these are, and which limits were left out
};
[[nodiscard]] OtherProcess by_process(const profile::Profile& profile, checks::ProcessKind kind);

/// Whose figures a process has that nobody stated: "defaults of sla, build volume 200 x 200 x 200 mm".
[[nodiscard]] std::string default_figures(const checks::Process& process);

/// Law, cams, solids and rules for each process, no file: what `make` would find before it exports.
/// @throws core::InvalidInput as make
[[nodiscard]] report::Checked check(const profile::Profile& profile, std::span<const checks::ProcessKind> kinds);

}  // namespace fusee::pipeline
