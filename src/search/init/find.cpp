#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "fix/judge.h"
#include "fusee/checks/limits.h"
#include "fusee/core/progress.h"
#include "fusee/pipeline/evaluate.h"
#include "levers.h"
#include "reach.h"
#include "repair.h"
#include "search.h"
#include "springs.h"

namespace fusee::search::init {

namespace {

constexpr int kShortGenerations = 80;
constexpr int kMostObstacles = 3;                          // removed one after another
constexpr std::size_t kMostTried = 10;                     // other answers for which a whole design is searched
constexpr int kFurtherSteps = 2;                           // of a number that was tried in vain
constexpr double kMoreRoom = 1.05;                         // than the nearest design found needs
constexpr std::uint64_t kSeeds = 2;                        // searches before a joint that is nearly possible counts as impossible
constexpr double kNearly = 0.5;                            // sum of the shares by which such a joint breaks its limits
constexpr std::size_t kMostForOthers = 9000;               // candidates of other answers: an answer within half a minute
constexpr double kStronger = 1.05;                         // than the nearest design found needs
constexpr double kFurther = 0.85;                          // of a number that was tried in vain is tried next, or its inverse
constexpr double kSearchShare = 0.6, kSpringShare = 0.75;  // of the time

void ask_to_stop(const InitOptions& options) {
    if (options.stop && options.stop()) throw core::Stopped();
}

void tell(const InitOptions& options, double share, const std::string& step) {
    if (options.progress) options.progress(share, step);
}

/// One search, and its springs.
struct Attempt {
    std::optional<profile::Profile> profile;  ///< with springs; none: `binding` says why
    core::Findings binding;
    double missing = 0.0;
    std::size_t judged = 0;
};

Attempt attempt(const std::string& name, const Answers& answers, const Effort& effort, const InitOptions& options) {
    Searched searched = search_scales(name, answers, effort, options);
    Attempt result{{}, searched.binding, searched.missing, searched.judged};
    if (!searched.makeable) return result;
    tell(options, 1.0, "springs that can be wound");
    const auto sprung = with_springs(searched.profile);
    ask_to_stop(options);
    if (sprung)
        result.profile = *sprung;
    else
        result.binding = sprung.refusal();
    return result;
}

Result search_design(const std::string& name, const Answers& answers, const InitOptions& options) {
    InitOptions within = options;
    within.progress = [&](double share, const std::string& step) { tell(options, kSearchShare * share, step); };
    Result result;
    Attempt found;
    for (std::uint64_t seed = 1; seed <= kSeeds && !found.profile && found.missing < kNearly; ++seed) {
        Attempt next = attempt(name, answers, {.seed = seed}, within);
        result.judged += next.judged;
        if (seed == 1 || next.profile) found = std::move(next);
    }
    result.binding = found.binding;
    if (found.profile) result.binding = too_large(*found.profile, answers);
    if (!found.profile || !result.binding.empty()) return result;
    tell(options, kSpringShare, "every file, read back");
    const core::Findings findings = pipeline::evaluate(*found.profile, pipeline::Depth::kFiles).all();
    ask_to_stop(options);
    result.binding = fix::broken_in(findings, core::Severity::kError);
    if (result.binding.empty()) result.design = Design{*found.profile, findings};
    return result;
}

/// A contour that just fits leaves nothing for the other part and the rules; a law that just reaches the loads is one that reaches them.
double ease_of(const core::Findings& broken) { return broken.front().rule.starts_with("limit.") ? 0.05 : 0.0; }

/// The answers with these changes. @param ease share by which a number goes beyond what the condition needs
std::optional<Changed> with_changes(Changed now, const core::Changes& changes, double ease) {
    for (const core::Change& change : changes) {
        std::string text = change.value;
        if (ease > 0.0 && change.key != "--cable") {
            const double value = std::stod(change.value), was = std::stod(change.was);
            text = fmt::format("{:.3g}", value * (value > was ? 1.0 + ease : 1.0 - ease));
        }
        auto next = changed(now.answers, change.key, text);
        if (!next) return std::nullopt;
        now = {next->answers, {now.other.changes, next->other.options}};
        now.other.changes.push_back({change.key, text, change.was});
    }
    return now;
}

/// How many times as strong the cable, the shaft and the other loaded parts would have to be.
struct Lacking {
    double cable = 1.0, shaft = 1.0, other = 1.0;
    [[nodiscard]] bool any() const { return std::max({cable, shaft, other}) > 1.0; }
};

Lacking lacking_strength(const core::Findings& broken) {
    Lacking lacking;
    const std::pair<const char*, double Lacking::*> rules[] = {{"cable.breaking_load", &Lacking::cable},
                                                               {"cable.anchor_load", &Lacking::cable},
                                                               {"joint.shaft_strength", &Lacking::shaft},
                                                               {"joint.frame_screws", &Lacking::other},
                                                               {"structure.layer_strength", &Lacking::other}};
    for (const core::Finding& f : broken)
        for (const auto& [rule, part] : rules) {
            const double times = f.bound == core::Bound::kAtLeast ? f.allowed / f.measured : f.measured / f.allowed;
            if (f.rule == rule && std::isfinite(times)) lacking.*part = std::max(lacking.*part, times);
        }
    return lacking;
}

/// The thinnest cable of the same kind that is so many times as strong.
std::optional<std::string> stronger_cable(const Answers& answers, double times) {
    if (answers.breaking_load > 0.0) return std::nullopt;  // stated: that of another one is not known
    const auto sizes = checks::cable_sizes(answers.construction);
    const double wanted = times * checks::usual_cable(answers.construction, answers.cable);
    auto size = sizes.at_least(core::mm_from_m(answers.cable));
    while (size && checks::usual_cable(answers.construction, core::m_from_mm(*size)) < wanted) size = sizes.at_least(*size * 1.01);
    return size ? std::optional(fmt::format("{} {:g}", answers.construction, *size)) : std::nullopt;
}

/// The answers with what bears the loads: another cable and shaft, or less torque where no answer makes the part stronger.
/// @param thicker a stronger cable is taken, if there is one; else less torque
std::optional<Changed> bearing(const Changed& now, const Lacking& lacking, bool thicker) {
    const Answers& a = now.answers;
    core::Changes changes;
    double less = lacking.other;
    if (const auto cable = thicker && lacking.cable > 1.0 ? stronger_cable(a, kStronger * lacking.cable) : std::nullopt)
        changes.push_back({"--cable", *cable, fmt::format("{} {:g}", a.construction, core::mm_from_m(a.cable))});
    else
        less = std::max(less, lacking.cable);
    if (less > 1.0) changes.push_back({"--torque", fmt::format("{:.2g}", a.torque / (kStronger * less)), fmt::format("{:g}", a.torque)});
    const double shaft = core::mm_from_m(a.shaft), thicker_shaft = shaft * std::cbrt(kStronger * lacking.shaft / less);
    if (const auto size = checks::shaft_sizes().at_least(thicker_shaft); size && lacking.shaft > less)
        changes.push_back({"--shaft", fmt::format("{:g}", *size), fmt::format("{:g}", shaft)});
    return changes.empty() ? std::nullopt : with_changes(now, changes, 0.0);
}

/// What bears the loads: with another cable, with more room for it, by less torque.
std::vector<Changed> bearing_changes(const Answers& answers, const Lacking& lacking) {
    std::vector<Changed> changes;
    const double bed = core::mm_from_m(answers.bed);
    const core::Change roomier{"--bed", fmt::format("{:.3g}", 1.5 * bed), fmt::format("{:g}", bed)};
    const auto thicker = bearing({answers, {}}, lacking, true), lighter = bearing({answers, {}}, lacking, false);
    if (thicker) changes.push_back(*thicker);
    if (const auto wide = thicker ? with_changes(*thicker, {roomier}, 0.0) : std::nullopt) changes.push_back(*wide);
    if (lighter) changes.push_back(*lighter);
    return changes;
}

/// Changes of one answer that often help, the smallest first.
std::vector<Changed> usual_changes(const Answers& answers, const core::Findings& binding) {
    const Lacking lacking = lacking_strength(binding);
    std::vector<Changed> changes;
    if (lacking.any()) changes = bearing_changes(answers, lacking);
    const auto add = [&](const std::string& option, const std::string& text) {
        if (auto there = changed(answers, option, text)) changes.push_back(std::move(*there));
    };
    const auto sizes = checks::cable_sizes(answers.construction);
    const double cable = core::mm_from_m(answers.cable), shaft = core::mm_from_m(answers.shaft);
    const auto add_cable = [&](std::optional<double> size) {
        if (size) add("--cable", fmt::format("{} {:g}", answers.construction, *size));
    };
    const auto add_room = [&](double contour_radius) {
        if (Changed there = with_room(answers, contour_radius); !there.other.changes.empty()) changes.push_back(std::move(there));
    };
    for (const core::Finding& f : binding)
        if (f.rule == "limit.contour_radius") add_room(kMoreRoom * core::m_from_mm(f.measured));
    const auto add_number = [&](const std::string& option, double value) { add(option, fmt::format("{:.3g}", value)); };
    if (std::any_of(binding.begin(), binding.end(), [](const core::Finding& f) { return f.rule.starts_with("cover."); }))
        add_number("--friction", kFurther * answers.friction);
    if (answers.overdrive > 0.0) add_number("--overdrive", kFurther * answers.overdrive);
    if (answers.joint_stiffness > 0.0) add("--joint-stiffness", "0");
    if (!lacking.any()) add_cable(sizes.at_most(cable * 0.99));
    if (const auto size = checks::shaft_sizes().at_most(shaft * 0.85)) add("--shaft", fmt::format("{:g}", *size));
    if (const auto size = checks::shaft_sizes().at_least(shaft * 1.2)) add("--shaft", fmt::format("{:g}", *size));
    add_cable(sizes.at_least(cable * 1.01));
    add_room(2.0 * contour_limit(answers));
    for (const double share : {0.7, 0.4}) add_number("--torque", share * answers.torque);
    if (answers.construction != "fibre") add("--cable", fmt::format("fibre {:g}", cable));
    return changes;
}

/// One change after another, from this lever on each the least that removes what is broken at once, until candidates can be judged.
/// @returns none if an obstacle has no lever
std::optional<Changed> unobstructed(const Answers& answers, OtherAnswers lever, double ease, const InitOptions& options) {
    std::optional<Changed> now = Changed{answers, {}};
    for (int i = 0; i < kMostObstacles; ++i) {
        now = with_changes(*std::move(now), lever.changes, ease);
        if (!now) return std::nullopt;
        const core::Findings broken = broken_at_once(now->answers, options);
        if (broken.empty()) return now;
        const std::vector<OtherAnswers> levers = find_levers(now->answers, broken, options);
        if (levers.empty()) return std::nullopt;
        lever = levers.front();
        ease = ease_of(broken);
    }
    return std::nullopt;
}

/// The last change once more, where it was tried in vain: other limits may come after those that it met.
std::optional<Changed> further(const Changed& now) {
    static const std::set<std::string> numbers{"--overdrive", "--torque", "--least", "--friction", "--joint-stiffness"};
    const core::Change& last = now.other.changes.back();
    if (numbers.count(last.key) == 0) return std::nullopt;
    const double value = std::stod(last.value), next = value > std::stod(last.was) ? value / kFurther : value * kFurther;
    Changed again = now;
    again.other.changes.pop_back();
    return with_changes(again, {{last.key, fmt::format("{:.3g}", next), last.was}}, 0.0);
}

/// Springs are wound for the best joint of a search: that none can be for the first one without errors says nothing.
bool lacks_springs(const core::Findings& binding) { return !binding.empty() && binding.front().rule == "init.spring"; }

/// The first of the changes that gives a joint whose solids and frame no rule refuses. Where no joint is found, the same change is tried
/// farther before the next one; where solids or frame do not bear the loads, the same with what bears them.
/// @param binding limits that the joint without a change breaks
std::optional<OtherAnswers> first_made(const std::string& name, std::vector<Changed> changes, const core::Findings& binding,
                                       const InitOptions& options) {
    InitOptions within = options;
    within.progress = {};
    struct Next {
        Changed changed;
        int steps = 0;  // that its last change has gone further
    };
    std::vector<Next> stack;
    for (auto change = changes.rbegin(); change != changes.rend(); ++change) stack.push_back({std::move(*change)});
    std::size_t tried = 0, judged = 0;
    bool first = !lacks_springs(binding);
    for (; !stack.empty() && tried < kMostTried && judged < kMostForOthers; ++tried) {
        const auto [now, steps] = std::move(stack.back());
        stack.pop_back();
        const core::Change& last = now.other.changes.back();
        tell(options, kSearchShare + (1.0 - kSearchShare) * double(tried) / double(kMostTried),
             fmt::format("not possible; the same with {} {}", last.key, last.value));
        Attempt next;
        if (broken_at_once(now.answers, within).empty())
            next = attempt(name, now.answers, {.generations = kShortGenerations, .first = first}, within);
        judged += next.judged;
        first = first && !lacks_springs(next.binding);
        if (!next.profile) {
            if (auto there = steps < kFurtherSteps ? further(now) : std::nullopt) stack.push_back({*std::move(there), steps + 1});
            continue;
        }
        const core::Findings errors =
            fix::broken_in(pipeline::evaluate(*next.profile, pipeline::Depth::kSolid).all(), core::Severity::kError);
        if (errors.empty()) return now.other;
        if (auto stronger = bearing(now, lacking_strength(errors), true)) stack.push_back({*std::move(stronger)});
    }
    return std::nullopt;
}

Answers repaired(Answers answers, const Repair& repair) {
    answers.law = repair.law;
    return answers;
}

/// The design of the nearest law that can be made.
Result repaired_design(const std::string& name, const Answers& answers, const InitOptions& options) {
    tell(options, 0.0, "not possible; the nearest law");
    Result result;
    const auto repair = find_repair(answers, options);
    if (!repair) return result;
    result = search_design(name, repaired(answers, *repair), options);
    if (result.design) result.repair = *repair;
    return result;
}

/// What would have to change for the conditions that `broken` names, and a joint with the smallest changes.
void refuse_at_once(Result& result, const core::Findings& broken, const std::string& name, const Answers& answers,
                    const InitOptions& options) {
    tell(options, 0.0, "not possible; what would have to change");
    result.at_once = true;
    result.binding = broken;
    result.levers = find_levers(answers, broken, options);
    std::vector<Changed> free;
    for (const OtherAnswers& lever : result.levers)
        if (auto there = free.size() < kMostTried ? unobstructed(answers, lever, ease_of(broken), options) : std::nullopt)
            free.push_back(*there);
    result.nearest = first_made(name, std::move(free), broken, options);
}

}  // namespace

Result find_design(const std::string& name, const Answers& answers, const InitOptions& options) {
    require_consistent(answers);
    const core::Findings broken = broken_at_once(answers, options);
    Result result;
    if (broken.empty()) {
        result = search_design(name, answers, options);
        if (!result.design) result.nearest = first_made(name, usual_changes(answers, result.binding), result.binding, options);
    } else {
        if (options.repair && answers.law) result = repaired_design(name, answers, options);
        if (!result.design) refuse_at_once(result, broken, name, answers, options);
    }
    const Answers held = result.repair ? repaired(answers, *result.repair) : answers;
    if (!held.law || MeasuredLaw::of(*held.law)) result.stores = stores_of(held, options.catalogue);
    tell(options, 1.0, result.design ? "done" : "not possible");
    return result;
}

std::string profile_text(const Design& design, const Answers& answers) {
    const std::string options = options_text(answers);
    return fmt::format(
        "# A first profile, scaled from profiles/pnrvsa.toml and searched for these answers: fusee init{}{}\n"
        "# Each comment is the meaning of its key. All keys: docs/profile.md, or `fusee keys`.\n{}",
        options.empty() ? " --yes" : " ", options, profile::to_commented_toml(design.profile));
}

}  // namespace fusee::search::init
