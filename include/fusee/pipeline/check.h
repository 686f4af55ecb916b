#pragma once
#include <span>
#include <string>
#include <vector>

#include "fusee/checks/check.h"
#include "fusee/core/finding.h"
#include "fusee/profile/profile.h"

namespace fusee::pipeline {

/// Findings of the rules for one part.
struct CheckedPart {
    std::string name;  ///< "k_se", or that of a mesh's file
    core::Findings findings;
};

/// Parts as one process would make them.
struct CheckedProcess {
    std::string process;   ///< "fdm"
    std::string figures;   ///< whose limits these are, and which were left out
    bool own = true;       ///< it is the one that the profile names
    core::Findings about;  ///< of the law, or of the design as a whole
    std::vector<CheckedPart> parts;

    [[nodiscard]] core::Findings all() const;
};

/// The result of `fusee check`.
struct Checked {
    std::string name;    ///< of the design or the mesh
    std::string sha256;  ///< of what was checked
    std::string input;   ///< one line: the input
    std::vector<CheckedProcess> processes;

    /// Some process makes every part without an error.
    [[nodiscard]] bool makeable() const;
};

/// The finding that binds: of the gravest severity, the one farthest beyond its limit in proportion; nullptr where none is broken.
[[nodiscard]] const core::Finding* binding(const core::Findings& findings);

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
[[nodiscard]] Checked check(const profile::Profile& profile, std::span<const checks::ProcessKind> kinds);

}  // namespace fusee::pipeline
