#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/checks/check.h"
#include "fusee/inspect/file.h"

/// Rules for third-party meshes: only the mesh and the process are known (docs/guides/check.md).
namespace fusee::inspect {

/// The input of a rule: a body of a third-party file and its process.
struct Foreign {
    const Body& body;  ///< of a rule for files: the first one
    const checks::Process& process;
    std::span<const checks::Override> overrides = {};  ///< limits that replace the rules' own
    const File* file = nullptr;                        ///< for the rules for files; nullptr: for those for bodies
};

/// A finding and its triangles.
struct Marked {
    core::Finding finding;
    std::vector<std::uint32_t> triangles = {};  ///< of the body, or of the file; ascending; empty where the finding passes
};

/// One rule for a mesh: a row of its topic's table in src/inspect/rules.
struct Rule : checks::RuleInfo {
    using Measure = std::function<std::optional<Marked>(const Foreign&, const checks::Allowed&)>;

    Measure measure;       ///< nothing where it does not apply
    bool of_file = false;  ///< measured once for a file; else for each of its bodies by itself
};
using Rules = std::vector<Rule>;

/// All rules, in the order of the report.
[[nodiscard]] std::span<const Rule> rules();

/// Runs every rule for files, if `part.file` is one, or else every rule for bodies. @param name of file or body in the findings
[[nodiscard]] std::vector<Marked> check(const Foreign& part, const std::string& name);

}  // namespace fusee::inspect
