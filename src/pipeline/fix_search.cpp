#include "fix_search.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace fusee::pipeline {

namespace {

constexpr double kLeft = 3.0;  // what an objection that is left is reckoned to cost: about a preload's change

bool has(const core::Findings& findings, const std::string& name) {
    return std::any_of(findings.begin(), findings.end(), [&name](const core::Finding& f) { return name_of(f) == name; });
}

std::vector<std::string> names(const core::Findings& findings) {
    std::vector<std::string> all;
    for (const core::Finding& f : findings) all.push_back(name_of(f));
    return all;
}

/// The same for the same values.
std::string signature(const Choices& choices) {
    std::string text;
    for (const auto& [key, choice] : choices) text += key + "=" + choice.value + "\n";
    return text;
}

}  // namespace

void Search::push(const NodePtr& node, int left) { queue_.push({node->cost + kLeft * std::max(0, left), sequence_++, node}); }

/// @param left objections hoped for
void Search::add(const NodePtr& parent, Choices choices, int left) {
    if (!seen_.insert(signature(choices)).second) return;
    const double cost = drafts_.cost(choices);
    push(std::make_shared<Node>(Node{std::move(choices), cost, parent, {}}), left);
}

void Search::keep_nearest(const Node& node, bool made) {
    const double left = node.verdict->left() - (made ? 0.5 : 0.0);  // of two with as many objections the one that came as far as its files
    if (result_.found || node.verdict->clear() || left >= least_left_) return;
    least_left_ = left;
    result_.choices = node.choices;
    result_.left = node.verdict->broken;
    if (options_.progress)
        options_.progress(fmt::format("{} judged; left: {}", judge_.judged(), fmt::join(names(node.verdict->broken), ", ")));
}

/// An objection that an ancestor had and the parent had no more.
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

/// Judges a draft and puts it back where it belongs; one that no profile can be is dropped.
void Search::look(const NodePtr& node) {
    const auto profile = drafts_.read(node->choices);
    if (!profile) return;
    node->verdict = if_allowed([&] { return judge_.drawing(*profile); });
    if (!node->verdict) return;
    keep_nearest(*node, false);
    note_circle(*node);
    push(node, node->verdict->left());
}

/// Each move against each finding, and the first against each at once.
void Search::follow(const NodePtr& node) {
    const auto profile = drafts_.read(node->choices);
    Choices at_once = node->choices;
    int left = static_cast<int>(node->verdict->broken.size());
    for (const core::Finding& finding : node->verdict->broken) {
        const std::vector<Move> all = suggested(finding, *node->verdict, *profile, node->choices);
        for (const Move& move : all) add(node, moved(node->choices, move), move.left);
        if (all.empty()) continue;
        at_once = moved(at_once, all.front());
        --left;
    }
    add(node, std::move(at_once), left);
}

/// What a suggestion names is looked at before a scan's many values are.
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

Choices Search::moved(const Choices& from, const Move& move) { return drafts_.with(from, move.changes, move.because, ++moves_); }

/// Is it made with every file? If not, what stands against that is what stands against the draft.
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

/// A draft that can be made ends the search only when what is cheaper has been looked at for a while.
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
    if (result_.found) result_.left.clear();
    return std::move(result_);
}

}  // namespace fusee::pipeline
