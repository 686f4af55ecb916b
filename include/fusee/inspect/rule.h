#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/checks/check.h"
#include "fusee/inspect/body.h"

/// Third-party parts, known by their mesh only, judged by the limits of a process (docs/guides/check.md).
namespace fusee::inspect {

/// All that a rule may look at: a third-party part, and how it is to be made.
struct Foreign {
    const Body& body;
    const checks::Process& process;
    std::span<const checks::Override> overrides = {};  ///< limits that hold in place of the rules' own
};

/// A finding, and the triangles that it is about.
struct Marked {
    core::Finding finding;
    std::vector<std::uint32_t> triangles = {};  ///< ascending; empty where the finding passes
};

/// One rule for a mesh: pure, one file under src/inspect.
struct Rule : checks::RuleInfo {
    using Measure = std::function<std::optional<Marked>(const Foreign&, const checks::Allowed&)>;

    Measure measure;  ///< nothing where it does not apply
};

/// Every rule, in the order in which they are reported.
[[nodiscard]] std::span<const Rule> rules();
/// Their Markdown table in docs/rules.md.
[[nodiscard]] std::string rules_reference();
/// What they are called and hold parts against.
[[nodiscard]] std::vector<const checks::RuleInfo*> rule_infos();

/// Runs every rule. @param name of the part in the findings
[[nodiscard]] std::vector<Marked> check(const Foreign& part, const std::string& name);

}  // namespace fusee::inspect
