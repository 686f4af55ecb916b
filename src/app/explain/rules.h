#pragma once
#include <string>
#include <vector>

#include "fusee/checks/rule.h"
#include "reply.h"

/// The rules of parts, of the joint and of meshes, in one list.
namespace fusee::app {

struct ListedRule {
    const checks::RuleInfo* info = nullptr;
    bool needs_mesh = false;
    std::vector<std::string> needs;  ///< keys without which it is not judged
};
[[nodiscard]] std::vector<ListedRule> all_rules();

/// The rules that `words` ask for: each asks for the groups and ids that begin with it; if there is none, for rules with the word in id,
/// title or measured quantity. No words: all. @throws core::InvalidInput naming a word that no rule has, and near ones
[[nodiscard]] std::vector<ListedRule> find_rules(const std::vector<std::string>& words);

[[nodiscard]] Json rule_json(const ListedRule& rule);

}  // namespace fusee::app
