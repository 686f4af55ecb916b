#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "fusee/checks/limits.h"
#include "fusee/core/error.h"
#include "fusee/core/progress.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/search/init.h"
#include "search.h"
#include "springs.h"

namespace fusee::search::init {

namespace {

constexpr int kShortGenerations = 150;
constexpr std::uint64_t kSeeds = 2;                        // searches before a joint counts as impossible
constexpr double kSearchShare = 0.6, kSpringShare = 0.75;  // of the time

void ask_to_stop(const Options& options) {
    if (options.stop && options.stop()) throw core::Stopped();
}

void tell(const Options& options, double share, const std::string& step) {
    if (options.progress) options.progress(share, step);
}

/// One search, and its springs.
struct Attempt {
    std::optional<profile::Profile> profile;  ///< with springs; none: `binding` says why
    core::Findings binding;
    std::size_t judged = 0;
};

Attempt attempt(const std::string& name, const Answers& answers, const Effort& effort, const Options& options) {
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

/// Changes of one answer, the smallest first.
std::vector<NearestChange> changes_of(const Answers& answers, std::vector<Answers>& changed) {
    std::vector<NearestChange> changes;
    const auto add = [&](const std::string& option, const std::string& text) {
        for (const Question& q : questions()) {
            if (q.option != option || q.shown(answers) == text) continue;
            Answers other = answers;
            q.enter(other, text);
            changes.push_back({{option, q.shown(other), q.shown(answers)}, options_text(other)});
            changed.push_back(other);
        }
    };
    const auto sizes = checks::cable_sizes(answers.construction);
    const double cable = core::mm_from_m(answers.cable), shaft = core::mm_from_m(answers.shaft);
    const auto add_cable = [&](std::optional<double> size) {
        if (size) add("--cable", fmt::format("{} {:g}", answers.construction, *size));
    };
    add_cable(sizes.at_least(cable * 1.01));
    add_cable(sizes.at_most(cable * 0.99));
    if (const auto size = checks::shaft_sizes().at_least(shaft * 1.2)) add("--shaft", fmt::format("{:g}", *size));
    if (const auto size = checks::shaft_sizes().at_most(shaft * 0.85)) add("--shaft", fmt::format("{:g}", *size));
    for (const double larger : {1.5, 2.0}) add("--bed", fmt::format("{:g}", core::mm_from_m(larger * answers.bed)));
    for (const double share : {0.7, 0.4, 0.2}) add("--torque", fmt::format("{:.3g}", share * answers.torque));
    if (answers.joint_stiffness > 0.0) add("--joint-stiffness", "0");
    if (answers.construction != "fibre") add("--cable", fmt::format("fibre {:g}", cable));
    add_cable(sizes.at_most(cable * 0.5));
    add_cable(sizes.at_least(cable * 2.0));
    add("--process", answers.process == checks::ProcessKind::kSla ? "mill4" : "sla");
    return changes;
}

std::optional<NearestChange> nearest_change(const std::string& name, const Answers& answers, const Options& options) {
    std::vector<Answers> changed;
    const std::vector<NearestChange> changes = changes_of(answers, changed);
    for (std::size_t i = 0; i < changes.size(); ++i) {
        Options within = options;
        within.progress = {};
        tell(options, kSearchShare + (1.0 - kSearchShare) * double(i) / double(changes.size()),
             fmt::format("not possible; the same with {} {}", changes[i].answer.key, changes[i].answer.value));
        try {
            require_consistent(changed[i]);
        } catch (const core::InvalidInput&) {
            continue;  // an overdrive torque that was stated
        }
        if (attempt(name, changed[i], {.generations = kShortGenerations, .first = true}, within).profile) return changes[i];
    }
    return std::nullopt;
}

}  // namespace

Result find_design(const std::string& name, const Answers& answers, const Options& options) {
    require_consistent(answers);
    Options within = options;
    within.progress = [&](double share, const std::string& step) { tell(options, kSearchShare * share, step); };
    Result result;
    Attempt found;
    for (std::uint64_t seed = 1; seed <= kSeeds && !found.profile; ++seed) {
        Attempt next = attempt(name, answers, {.seed = seed}, within);
        result.judged += next.judged;
        if (seed == 1 || next.profile) found = std::move(next);
    }
    result.binding = found.binding;
    if (found.profile) {
        tell(options, kSpringShare, "every file, read back");
        const core::Findings findings = pipeline::evaluate(*found.profile, pipeline::Depth::kFiles).all();
        ask_to_stop(options);
        result.binding = errors_of(findings);
        if (result.binding.empty()) result.design = Design{*found.profile, findings};
    }
    if (!result.design) result.nearest = nearest_change(name, answers, options);
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
