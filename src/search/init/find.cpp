#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "energy.h"
#include "fusee/checks/limits.h"
#include "fusee/core/error.h"
#include "fusee/core/progress.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/search/init.h"
#include "levers.h"
#include "reach.h"
#include "repair.h"
#include "search.h"
#include "springs.h"

namespace fusee::search::init {

namespace {

constexpr int kShortGenerations = 150;
constexpr int kMostObstacles = 3;                          // removed one after another
constexpr std::size_t kMostTried = 6;                      // other answers for which a whole design is searched
constexpr double kMoreRoom = 1.05;                         // than the nearest design found needs
constexpr std::uint64_t kSeeds = 2;                        // searches before a joint counts as impossible
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
    std::size_t judged = 0;
};

Attempt attempt(const std::string& name, const Answers& answers, const Effort& effort, const InitOptions& options) {
    Searched searched = search_scales(name, answers, effort, options);
    Attempt result{{}, searched.binding, searched.judged};
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

/// The errors of all files, read back; empty: `fusee make` accepts the profile.
core::Findings errors_of(const core::Findings& findings) {
    core::Findings errors;
    std::copy_if(findings.begin(), findings.end(), std::back_inserter(errors),
                 [](const core::Finding& f) { return f.severity == core::Severity::kError; });
    return errors;
}

Result search_design(const std::string& name, const Answers& answers, const InitOptions& options) {
    InitOptions within = options;
    within.progress = [&](double share, const std::string& step) { tell(options, kSearchShare * share, step); };
    Result result;
    Attempt found;
    for (std::uint64_t seed = 1; seed <= kSeeds && !found.profile; ++seed) {
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
    result.binding = errors_of(findings);
    if (result.binding.empty()) result.design = Design{*found.profile, findings};
    return result;
}

/// Changes of one answer that often help, the smallest first.
std::vector<Changed> usual_changes(const Answers& answers, const core::Findings& binding) {
    std::vector<Changed> changes;
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
    add_cable(sizes.at_most(cable * 0.99));
    if (const auto size = checks::shaft_sizes().at_most(shaft * 0.85)) add("--shaft", fmt::format("{:g}", *size));
    if (const auto size = checks::shaft_sizes().at_least(shaft * 1.2)) add("--shaft", fmt::format("{:g}", *size));
    add_cable(sizes.at_least(cable * 1.01));
    add_room(2.0 * contour_limit(answers));
    for (const double share : {0.7, 0.4}) add("--torque", fmt::format("{:.3g}", share * answers.torque));
    if (answers.joint_stiffness > 0.0) add("--joint-stiffness", "0");
    if (answers.construction != "fibre") add("--cable", fmt::format("fibre {:g}", cable));
    return changes;
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

/// The first of the changes that gives a design.
std::optional<OtherAnswers> first_made(const std::string& name, std::vector<Changed> changes, const InitOptions& options) {
    if (changes.size() > kMostTried) changes.resize(kMostTried);
    for (std::size_t i = 0; i < changes.size(); ++i) {
        InitOptions within = options;
        within.progress = {};
        const core::Change& last = changes[i].other.changes.back();
        tell(options, kSearchShare + (1.0 - kSearchShare) * double(i) / double(changes.size()),
             fmt::format("not possible; the same with {} {}", last.key, last.value));
        if (!broken_at_once(changes[i].answers, within).empty()) continue;
        if (attempt(name, changes[i].answers, {.generations = kShortGenerations, .first = true}, within).profile) return changes[i].other;
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
    result.nearest = first_made(name, std::move(free), options);
}

}  // namespace

Result find_design(const std::string& name, const Answers& answers, const InitOptions& options) {
    require_consistent(answers);
    const core::Findings broken = broken_at_once(answers, options);
    Result result;
    if (broken.empty()) {
        result = search_design(name, answers, options);
        if (!result.design) result.nearest = first_made(name, usual_changes(answers, result.binding), options);
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
