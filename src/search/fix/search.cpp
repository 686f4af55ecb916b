#include "search.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fusee/core/lists.h"
#include "standard.h"

namespace fusee::search::fix {

namespace {

constexpr double kError = 1000.0;  // warnings that one error outweighs
constexpr double kLeft = 3.0;      // estimated cost of a finding that is left: about that of a change of preload

bool has(const core::Findings& findings, const std::string& name) {
    return std::any_of(findings.begin(), findings.end(), [&name](const core::Finding& f) { return name_of(f) == name; });
}

std::vector<std::string> names(const core::Findings& findings) {
    return core::each<std::string>(findings, [&](const core::Finding& f) { return name_of(f); });
}

/// Keys whose value differs, without those that follow others.
std::vector<std::string> changed_keys(const Choices& now, const Choices& before) {
    std::vector<std::string> keys;
    for (const auto& [key, choice] : now)
        if (const auto was = before.find(key); choice.follows.empty() && (was == before.end() || was->second.value != choice.value))
            keys.push_back(key);
    return keys;
}

/// The value of the same key, nearer to the old one, that the broken limit suggests; empty if it suggests none.
std::string asked_back(const Conflict& conflict) {
    const std::optional<double> from = number_in(conflict.change.was), to = number_in(conflict.change.value);
    if (!from || !to) return {};
    for (const core::Changes& changes : conflict.other.suggestion.changes())
        for (const core::Change& change : changes)
            if (const auto asks = number_in(change.value); change.key == conflict.change.key && asks && (*asks - *to) * (*to - *from) < 0.0)
                return change.value;
    return {};
}

/// Equal for equal values.
std::string signature(const Choices& choices) {
    std::string text;
    for (const auto& [key, choice] : choices) text += key + "=" + choice.value + "\n";
    return text;
}

bool is_of_spring(const std::string& key, const std::string& part) { return key.starts_with(part + ".spring."); }

/// Is the finding about a cam or spring that does not fit the law?
bool is_of_cam(const core::Finding& f) { return (f.rule.starts_with("cam.") || f.rule.starts_with("spring.")) && !part_of(f).empty(); }

/// Number of findings left of the finding's part.
int share_of(const core::Finding& finding, const Verdict& verdict) {
    const auto of_part = [part = part_of(finding)](const core::Finding& f) { return part_of(f) == part; };
    return static_cast<int>(std::count_if(verdict.broken.begin(), verdict.broken.end(), of_part)) +
           (verdict.unseen > 0 && finding.rule.starts_with("cam.") ? kBehindCam : 0);
}

/// Was the part's spring changed for that?
bool has_other_spring(const std::string& part, const Choices& choices) {
    return std::any_of(choices.begin(), choices.end(),
                       [&part](const auto& entry) { return is_of_spring(entry.first, part) && is_of_cam(entry.second.because); });
}

/// Were the ends of the law moved?
bool has_other_range(const Choices& choices) { return choices.contains("law.start_torque_Nm") || choices.contains("law.end_torque_Nm"); }

/// A key that has no meaning yet may get one from the first change: a helix its pitch.
bool allowed(const core::Changes& changes, const profile::Profile& draft) {
    const bool known = std::all_of(changes.begin(), changes.end(), [](const core::Change& c) { return policy_of(c.key) != nullptr; });
    return known && profile::value_text(draft, changes.front().key).has_value();
}

}  // namespace

void Search::push(const NodePtr& node, int left) { queue_.push({node->cost + kLeft * std::max(0, left), sequence_++, node}); }

/// @param left findings expected
void Search::add(const NodePtr& parent, Choices choices, int left) {
    if (!seen_.insert(signature(choices)).second) return;
    const double cost = drafts_.cost(choices);
    push(std::make_shared<Node>(Node{std::move(choices), cost, parent, {}}), left);
}

void Search::keep_nearest(const Node& node, bool made) {
    // Fewer errors come first, then fewer findings, then drafts that were made with files.
    const double left = kError * node.verdict->errors() + node.verdict->left() - (made ? 0.5 : 0.0);
    if (result_.found || node.verdict->clear() || left >= least_left_) return;
    least_left_ = left;
    result_.choices = node.choices;
    result_.left = node.verdict->broken;
    if (options_.progress)
        options_.progress(fmt::format("{} judged; left: {}", judge_.judged(), fmt::join(names(node.verdict->broken), ", ")));
}

/// A finding that an ancestor had and the parent no longer had.
void Search::note_circle(const Node& node) {
    if (!node.parent) return;
    for (const std::string& name : names(node.verdict->broken)) {
        if (has(node.parent->verdict->broken, name)) continue;
        bool earlier = false;
        for (auto at = node.parent->parent; at && !earlier; at = at->parent) earlier = has(at->verdict->broken, name);
        if (!earlier) continue;
        for (const auto& [key, choice] : node.choices)
            if (const auto before = node.parent->choices.find(key);
                before == node.parent->choices.end() || before->second.value != choice.value)
                result_.circles.insert(fmt::format("{} = {}, for {}, brings {} back", key, choice.value, name_of(choice.because), name));
    }
}

/// Limits that one single move has broken.
void Search::note_conflicts(const Node& node) {
    if (!node.parent) return;
    const std::vector<std::string> changed = changed_keys(node.choices, node.parent->choices);
    if (changed.empty()) return;
    const Choice& choice = node.choices.at(changed.front());
    for (const std::string& key : changed)
        if (node.choices.at(key).move != choice.move) return;
    for (const core::Finding& broken : node.verdict->broken) {
        const std::string one = name_of(choice.because), other = name_of(broken);
        if (one == other || has(node.parent->verdict->broken, other)) continue;
        const auto before = node.parent->choices.find(changed.front());
        Conflict conflict{choice.because, broken, {changed.front(), choice.value}, {}};
        conflict.change.was = before == node.parent->choices.end() ? drafts_.was(conflict.change.key) : before->second.value;
        conflict.asks = asked_back(conflict);
        const auto [at, is_new] = broken_by_.try_emplace({one, other}, conflict);
        if (!is_new && at->second.asks.empty() && !conflict.asks.empty()) at->second = conflict;
    }
}

/// First the conflicts in which the other limit suggests the way back, or a change that breaks the one; then the other limits broken by a
/// change for a limit that is left.
void Search::keep_conflicts() {
    std::vector<Conflict> one_way;
    for (const auto& [names, conflict] : broken_by_) {
        const auto& [one, other] = names;
        const bool both_ways = !conflict.asks.empty() || broken_by_.contains({other, one});
        if (both_ways && (has(result_.left, one) || has(result_.left, other)))
            result_.conflicts.push_back(conflict);
        else if (has(result_.left, one))
            one_way.push_back(conflict);
    }
    result_.conflicts.insert(result_.conflicts.end(), one_way.begin(), one_way.end());
}

/// Judges a draft and ranks it again; drops a draft that is not a valid profile.
void Search::look(const NodePtr& node) {
    const auto profile = drafts_.read(node->choices);
    if (!profile) return;
    node->verdict = if_allowed([&] { return judge_.drawing(*profile); });
    if (!node->verdict) return;
    keep_nearest(*node, false);
    note_circle(*node);
    note_conflicts(*node);
    push(node, node->verdict->left());
}

/// Each move against each finding, and all first moves at once.
void Search::follow(const NodePtr& node) {
    const auto profile = drafts_.read(node->choices);
    Choices at_once = node->choices;
    int left = static_cast<int>(node->verdict->broken.size());
    for (const core::Finding& finding : node->verdict->broken) {
        const std::vector<Move> all = suggested(finding, *node->verdict, *profile, node->choices, drafts_, result_.refused);
        for (const Move& move : all) add(node, moved(node->choices, move), move.left);
        if (all.empty()) continue;
        at_once = moved(at_once, all.front());
        --left;
    }
    add(node, std::move(at_once), left);
}

/// Suggestions come before the many values of a scan.
void Search::expand(const NodePtr& node) {
    if (!node->followed) {
        follow(node);
        node->followed = true;
        return push(node, node->verdict->left() + 1);
    }
    if (result_.found) return;
    const auto profile = drafts_.read(node->choices);
    for (const Move& move : scanned(*node->verdict, *profile, node->choices, scan_)) add(node, moved(node->choices, move), move.left);
}

Choices Search::moved(const Choices& from, const Move& move) {
    return drafts_.with(from, move.changes, move.because, ++moves_, move.follows);
}

/// Makes the draft with every file; the findings of a failure become those of the draft.
bool Search::makes(const NodePtr& node) {
    const auto profile = drafts_.read(node->choices);
    const auto verdict = if_allowed([&] { return judge_.making(*profile); });
    if (!verdict) return false;
    if (verdict->clear()) return true;
    node->verdict = verdict;
    keep_nearest(*node, true);
    push(node, node->verdict->left());
    return false;
}

/// After the first draft that can be made, the search goes on for a while among the cheaper ones.
Searched Search::run() {
    constexpr int kGoOn = 80, kMakeOn = 2;  // judged and made beyond the first that can be made
    int most = options_.most_judged, most_made = options_.most_made;
    double least_cost = std::numeric_limits<double>::infinity();
    add(nullptr, {}, 0);
    while (!queue_.empty() && judge_.judged() < most && judge_.made() < most_made) {
        const NodePtr node = queue_.top().node;
        queue_.pop();
        if (node->cost >= least_cost) continue;
        if (!node->verdict) {
            look(node);
        } else if (!node->verdict->clear()) {
            expand(node);
        } else if (makes(node)) {
            if (!result_.found) most = std::min(most, judge_.judged() + kGoOn), most_made = std::min(most_made, judge_.made() + kMakeOn);
            result_.found = true;
            least_cost = node->cost;
            result_.choices = node->choices;
        }
    }
    if (result_.found) {
        result_.left.clear();
        return std::move(result_);
    }
    keep_conflicts();
    if (!queue_.empty())
        result_.ended = judge_.made() >= most_made
                            ? fmt::format("the search ended when {} profiles had been made with every file", most_made)
                            : fmt::format("the search ended when {} profiles had been judged (--most)", most);
    return std::move(result_);
}

std::vector<Move> suggested(const core::Finding& finding, const Verdict& verdict, const profile::Profile& draft, const Choices& choices,
                            const Drafts& drafts, std::map<std::string, std::string>& refused) {
    const std::string part = part_of(finding);
    const bool spring_stays = is_of_cam(finding) && has_other_spring(part, choices);
    std::vector<Move> moves;
    for (const core::Changes& changes : finding.suggestion.changes()) {
        if (!allowed(changes, draft) || (spring_stays && is_of_spring(changes.front().key, part))) continue;
        Held held = hold(changes, draft, drafts);
        if (held.changes.empty())
            refused.try_emplace(held.key, held.refused);
        else
            moves.push_back({std::move(held.changes), std::move(held.follows), finding, static_cast<int>(verdict.broken.size()) - 1});
    }
    return moves;
}

std::vector<Move> scanned(const Verdict& verdict, const profile::Profile& draft, const Choices& choices, Scan& scan) {
    std::vector<Move> moves;
    bool law_scanned = has_other_range(choices);
    for (const core::Finding& finding : verdict.broken) {
        const bool of_law = finding.rule.starts_with("law.") || is_of_cam(finding);
        if (finding.severity != core::Severity::kError || !of_law) continue;
        if (!law_scanned)
            for (const Scan::Step& step : scan.laws(draft, choices)) moves.push_back({step.changes, step.follows, finding, step.left});
        law_scanned = true;
        if (!is_of_cam(finding) || has_other_spring(part_of(finding), choices)) continue;
        const auto kind = kind_of(part_of(finding), draft);
        for (const Scan::Step& step : scan.springs(kind, draft, choices))
            moves.push_back({step.changes, step.follows, finding, verdict.left() - share_of(finding, verdict) + step.left});
    }
    return moves;
}

}  // namespace fusee::search::fix
