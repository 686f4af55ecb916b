#include "moves.h"

#include <algorithm>

#include "policy.h"
#include "standard.h"

namespace fusee::search::fix {

namespace {

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
