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
    std::string figures;   ///< source of the limits, and the limits left out
    bool own = true;       ///< it is the one that the profile names
    core::Findings about;  ///< of the law, or of the design as a whole
    std::vector<CheckedPart> parts;

    [[nodiscard]] core::Findings all() const;
};

/// The result of `fusee check`.
struct Checked {
    std::string name;    ///< of the design or the mesh
    std::string sha256;  ///< of the checked file
    std::string input;   ///< the input in one line
    std::vector<CheckedProcess> processes;

    /// Some process makes every part without an error.
    [[nodiscard]] bool makeable() const;
};

/// The binding finding: of the highest severity, the one with the largest relative excess; nullptr if none is broken.
[[nodiscard]] const core::Finding* binding(const core::Findings& findings);

/// A profile as another process would make it. The profile's own process keeps every figure. Another one takes its defaults
/// (docs/rules.md, table 3) and a build volume of 200 x 200 x 200 mm in place of [process], without those [[limits]] whose default depends
/// on the process.
struct OtherProcess {
    profile::Profile profile;
    std::string figures;  ///< source of the figures, and the limits left out
};
[[nodiscard]] OtherProcess by_process(const profile::Profile& profile, checks::ProcessKind kind);

/// Source of the figures of a process that the profile does not state: "defaults of sla, build volume 200 x 200 x 200 mm".
[[nodiscard]] std::string default_figures(const checks::Process& process);

/// Applies each suggested change of a broken finding to the profile and judges it by the rules that need no mesh. One that is not allowed,
/// that breaks a rule which held, or that leaves its finding as it is, is left out; if none remains, the suggestion says why.
void judge_suggestions(core::Findings& findings, const profile::Profile& profile);

/// Law, cams, solids and rules for each process, without files: the findings of `make` before it exports.
/// @throws core::InvalidInput as make
[[nodiscard]] Checked check(const profile::Profile& profile, std::span<const checks::ProcessKind> kinds);

}  // namespace fusee::pipeline
