#pragma once
#include <string>
#include <vector>

#include "fusee/core/finding.h"

namespace fusee::report {

/// What the rules say of one part.
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

/// What `fusee check` found.
struct Checked {
    std::string name;    ///< of the design or the mesh
    std::string sha256;  ///< of what was checked
    std::string input;   ///< one line: what was read
    std::vector<CheckedProcess> processes;

    /// Some process makes every part without a required change.
    [[nodiscard]] bool makeable() const;
};

/// The finding that binds: of the gravest severity, the one farthest beyond its limit in proportion; nullptr where none is broken.
[[nodiscard]] const core::Finding* binding(const core::Findings& findings);

/// One process: its findings but passes, as `fusee make` prints them. Several: a table, one line a process and part.
[[nodiscard]] std::string check_text(const Checked& checked);
/// The keys of docs/guides/check.md, in that order.
[[nodiscard]] std::string check_json(const Checked& checked);

}  // namespace fusee::report
