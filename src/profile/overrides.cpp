#include "overrides.h"

#include <fmt/format.h>

#include <cmath>

#include "fusee/assembly/rule.h"
#include "fusee/core/file.h"
#include "key.h"

namespace fusee::profile {

namespace {

constexpr const char* kShape = "[[limits]] with rule, one or more of its limits, and reason";

std::string all_limits(const checks::RuleInfo& rule) {
    std::string all;
    for (const checks::Limit& limit : rule.limits) all += fmt::format("{}{} ({})", all.empty() ? "" : ", ", limit.key(), limit.text());
    return fmt::format("{} has {}", rule.id, all);
}

/// One table of the array.
class Entry {
public:
    Entry(const toml::table& table, const RuleInfos& rules, core::TomlFaults& faults) : table_(table), rules_(rules), faults_(faults) {}

    void read(std::vector<checks::Override>& into) const {
        const checks::RuleInfo* rule = this->rule();
        const std::string reason = text("reason", "the reason for another limit, as text");
        if (rule == nullptr) return;  // its limits are unknown
        std::size_t named = 0;
        for (const auto& [key, node] : table_) {
            if (key.str() == "rule" || key.str() == "reason") continue;
            ++named;
            if (const checks::Limit* limit = limit_of(*rule, key)) read_limit(key, node, {*rule, *limit, reason}, into);
        }
        if (named == 0) refuse("rule", table_.source(), "no limit", all_limits(*rule));
    }

private:
    struct Place {
        const checks::RuleInfo& rule;
        const checks::Limit& limit;
        const std::string& reason;
    };

    void refuse(std::string_view key, const toml::source_region& at, std::string value, std::string allowed) const {
        faults_.add(at, fmt::format("limits.{}", key), std::move(value), std::move(allowed));
    }
    void read_limit(const toml::key& key, const toml::node& node, const Place& place, std::vector<checks::Override>& into) const {
        const bool twice = std::any_of(into.begin(), into.end(), [&](const checks::Override& other) {
            return other.rule == place.rule.id && other.limit == place.limit.key();
        });
        if (twice)
            refuse(key.str(), key.source(), "is repeated", "one value");
        else
            into.push_back({place.rule.id, place.limit.key(), number(key.str(), node, place.limit), place.reason});
    }
    /// "" if it is refused.
    [[nodiscard]] std::string text(const char* key, const std::string& allowed) const {
        const toml::node* node = table_.get(key);
        if (node == nullptr) return refuse(key, table_.source(), "missing", allowed), "";
        if (!node->is_string() || node->as_string()->get().find_first_not_of(" \t\n") == std::string::npos)
            return refuse(key, node->source(), core::shown(*node), allowed), "";
        return node->as_string()->get();
    }
    /// nullptr if it is unknown.
    [[nodiscard]] const checks::RuleInfo* rule() const {
        const std::string id = text("rule", "the id of a rule (docs/rules.md)");
        if (id.empty()) return nullptr;
        const auto found = std::find_if(rules_.begin(), rules_.end(), [&](const checks::RuleInfo* info) { return info->id == id; });
        if (found != rules_.end()) return *found;
        const std::string near = faults_.full() ? "" : nearest_rule(id, rules_).id;
        refuse("rule", table_.get("rule")->source(), fmt::format("unknown rule \"{}\"", id), "nearest known one: " + near);
        return nullptr;
    }
    /// nullptr if the rule does not have it.
    [[nodiscard]] const checks::Limit* limit_of(const checks::RuleInfo& rule, const toml::key& key) const {
        if (const checks::Limit* limit = rule.limit(key.str())) return limit;
        const bool named = std::any_of(rule.limits.begin(), rule.limits.end(),
                                       [&](const checks::Limit& l) { return key.str() == l.name || key.str().starts_with(l.name + "_"); });
        return refuse(key.str(), key.source(), named ? "not the unit of this limit" : "unknown limit", all_limits(rule)), nullptr;
    }
    [[nodiscard]] double number(std::string_view key, const toml::node& node, const checks::Limit& limit) const {
        const double value = node.is_integer()          ? static_cast<double>(node.as_integer()->get())
                             : node.is_floating_point() ? node.as_floating_point()->get()
                                                        : NAN;
        if (!std::isfinite(value))
            refuse(key, node.source(), core::shown(node), fmt::format("a finite number{}{}", limit.unit.empty() ? "" : " in ", limit.unit));
        return value;
    }

    const toml::table& table_;
    const RuleInfos& rules_;
    core::TomlFaults& faults_;
};

}  // namespace

RuleInfos design_rules() {
    RuleInfos all;
    for (const checks::Rule& rule : checks::rules()) all.push_back(&rule);
    const RuleInfos of_joint = checks::infos_of(assembly::rules());
    all.insert(all.end(), of_joint.begin(), of_joint.end());
    return all;
}

std::vector<checks::Override> read_overrides(const toml::node& node, const RuleInfos& rules, core::TomlFaults& faults) {
    std::vector<checks::Override> limits;
    if (node.is_array_of_tables())
        for (const toml::node& entry : *node.as_array()) Entry(*entry.as_table(), rules, faults).read(limits);
    else
        faults.add(node.source(), "limits", "not an array of tables", kShape);
    return limits;
}

std::vector<checks::Override> read_limits(const std::filesystem::path& path, const RuleInfos& rules) {
    const toml::table table = core::parse_toml(core::read_file(path, kLargestFile), path.string());
    core::TomlFaults faults(path.string());
    for (const auto& [key, node] : table)
        if (key.str() != "limits") faults.add(key.source(), key.str(), "has no meaning here", std::string("only ") + kShape);
    const toml::node* limits = table.get("limits");
    if (limits == nullptr) faults.add(table.source(), "limits", "missing", kShape);
    std::vector<checks::Override> read;
    if (limits != nullptr) read = read_overrides(*limits, rules, faults);
    faults.throw_if_any();
    return read;
}

std::string overrides_toml(const std::vector<checks::Override>& limits) {
    std::string toml;
    for (const checks::Override& o : limits)
        toml +=
            fmt::format("\n[[limits]]\nrule = {}\n{} = {}\nreason = {}\n", core::quoted(o.rule), o.limit, o.value, core::quoted(o.reason));
    return toml;
}

std::string overrides_reference() {
    return "### `[[limits]]`\n\n"
           "| key | allowed | default | meaning |\n|---|---|---|---|\n"
           "| `rule` | the id of a rule (docs/rules.md) | required | the rule whose limits change |\n"
           "| a limit of the rule | a finite number in the unit that ends its name | at least one | "
           "replaces the rule's limit for both parts; beyond `required_...` is an error, beyond `review_...` a warning |\n"
           "| `reason` | a text | required | is shown with every finding of the limit |\n\n";
}

}  // namespace fusee::profile
