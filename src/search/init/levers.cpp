#include "levers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "fusee/checks/limits.h"
#include "fusee/core/error.h"
#include "fusee/core/progress.h"
#include "reach.h"
#include "search.h"
#include "shapes.h"
#include "springs.h"

namespace fusee::search::init {

namespace {

constexpr int kSteps = 14, kContourSteps = 6;  // of a bisection: 1/16000 of the way; a contour takes a third of a second
constexpr double kFarther = 5.0;               // torques are tried up to this times the wanted one, and down to its inverse

/// A number that a person may answer otherwise: from its present value towards an end.
struct Lever {
    const char* option;
    double from, to;  ///< in the question's unit
};

std::vector<Lever> levers_of(const Answers& a) {
    const double least = a.least_torque() * a.ratio, most = a.overdrive_torque() * a.ratio;
    return {{"--overdrive", most, a.torque},
            {"--least", least, 0.99 * a.torque},
            {"--torque", a.torque, a.torque / kFarther},
            {"--torque", a.torque, a.torque * kFarther},
            {"--friction", a.friction, 0.005},
            {"--joint-stiffness", a.joint_stiffness, a.joint_stiffness > 0.0 ? chosen_stiffness(a) : 0.0}};
}

/// 3 digits, rounded towards `to`, so that the rounded value still holds.
std::string towards(double value, double to) {
    const double step = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
    return fmt::format("{:.6g}", step * (to < value ? std::floor(value / step + 1e-9) : std::ceil(value / step - 1e-9)));
}

using Holds = std::function<bool(const Answers&)>;

/// One torque in the place of another; those that are stated beside it keep their ratio to it.
std::optional<Changed> other_torque(const Answers& answers, const std::string& text) {
    Answers untied = answers;
    untied.overdrive = untied.least = 0.0;
    auto there = changed(untied, "--torque", text);
    if (!there) return std::nullopt;
    const double ratio = there->answers.torque / answers.torque;
    for (const auto& [option, stated] : {std::pair{"--overdrive", answers.overdrive}, {"--least", answers.least}}) {
        if (stated <= 0.0) continue;
        auto next = changed(there->answers, option, fmt::format("{:.4g}", ratio * stated));
        if (!next) return std::nullopt;
        there->answers = next->answers;
        there->other.changes.push_back({option, next->other.changes.front().value, fmt::format("{:g}", stated)});
        there->other.options = next->other.options;
    }
    return there;
}

std::optional<Changed> least_change(const Answers& answers, const Lever& lever, const Holds& holds, int steps) {
    const auto helping = [&](double value) -> std::optional<Changed> {
        const std::string text = towards(value, lever.to);
        auto there = std::string_view(lever.option) == "--torque" ? other_torque(answers, text) : changed(answers, lever.option, text);
        if (!there || !holds(there->answers)) return std::nullopt;
        there->other.changes.front().was = fmt::format("{:.4g}", lever.from);  // not 0, which stands for a share of the torque
        return there;
    };
    if (!(lever.to > 0.0) || lever.to == lever.from) return std::nullopt;
    auto best = helping(lever.to);
    double good = lever.to, bad = lever.from;
    for (int i = 0; i < steps && best; ++i) {
        const double middle = std::sqrt(good * bad);
        if (auto nearer = helping(middle)) {
            best = nearer;
            good = middle;
        } else {
            bad = middle;
        }
    }
    return best;
}

/// How much of an answer changes: a number by its logarithm, a word wholly.
double extent_of(const core::Change& change) {
    try {
        return std::abs(std::log(std::stod(change.value) / std::stod(change.was)));
    } catch (const std::exception&) {
        return 1.0;
    }
}

/// The thickest cable below the present one, of its kind, else the same one of fibre.
std::optional<Changed> other_cable(const Answers& a, const Holds& holds) {
    const auto sizes = checks::cable_sizes(a.construction);
    const double now = core::mm_from_m(a.cable);
    for (auto size = sizes.at_most(0.99 * now); size && *size > 0.3 * now; size = sizes.at_most(0.99 * *size))
        if (auto there = changed(a, "--cable", fmt::format("{} {:g}", a.construction, *size)); there && holds(there->answers)) return there;
    if (auto there = changed(a, "--cable", fmt::format("fibre {:g}", now)); there && holds(there->answers)) return there;
    return std::nullopt;
}

/// The room that the least contours need.
std::optional<Changed> other_room(const Answers& a, const core::Findings& broken, const Holds& holds) {
    double radius = 0.0;
    for (const core::Finding& f : broken)
        if (f.rule == "limit.contour_radius") radius = std::max(radius, core::m_from_mm(f.measured));
    if (radius <= 0.0 || !std::isfinite(radius)) return std::nullopt;
    Changed there = with_room(a, radius);
    return !there.other.changes.empty() && holds(there.answers) ? std::optional(there) : std::nullopt;
}

core::Findings broken_by_law(const Answers& answers) {
    if (!answers.law) return {};
    const auto law = MeasuredLaw::of(*answers.law);
    return law ? law->missing(answers) : law.refusal();
}

}  // namespace

std::optional<Result> refused_by_law(const Answers& answers) {
    Result result;
    result.at_once = true;
    result.binding = broken_by_law(answers);
    if (result.binding.empty()) return std::nullopt;
    result.levers = find_levers(answers, result.binding, {});
    return result;
}

core::Findings broken_at_once(const Answers& answers, const InitOptions& options) {
    if (options.stop && options.stop()) throw core::Stopped();
    if (core::Findings broken = broken_by_law(answers); !broken.empty()) return broken;
    if (core::Findings weak = not_held(stores_of(answers, {})); !weak.empty()) return weak;
    return broken_contours(answers, options.jobs);
}

std::vector<OtherAnswers> find_levers(const Answers& answers, const core::Findings& broken, const InitOptions& options) {
    const bool covered = !broken.front().rule.starts_with("cover.");
    if (broken.front().rule.starts_with("law.")) return {};
    const Holds holds = [&](const Answers& a) {
        return covered ? broken_at_once(a, options).empty() : MeasuredLaw::of(*a.law)->missing(a).empty();
    };
    std::vector<OtherAnswers> found;
    const auto add = [&](const std::optional<Changed>& there) {
        if (there) found.push_back(there->other);
    };
    for (const Lever& lever : levers_of(answers)) add(least_change(answers, lever, holds, covered ? kContourSteps : kSteps));
    if (covered) {
        add(other_room(answers, broken, holds));
        add(other_cable(answers, holds));
    }
    std::stable_sort(found.begin(), found.end(), [](const OtherAnswers& a, const OtherAnswers& b) {
        return extent_of(a.changes.front()) < extent_of(b.changes.front());
    });
    return found;
}

Changed with_room(const Answers& answers, double contour_radius) {
    const Room room = room_for(contour_radius, answers);
    Changed there{answers, {}};
    const auto enlarge = [&](const char* option, double now, double needed) {
        if (now <= 0.0 || needed <= now) return;
        auto next = changed(there.answers, option, fmt::format("{:g}", std::ceil(core::mm_from_m(needed))));
        if (!next) return;
        there.answers = next->answers;
        there.other.changes.push_back(next->other.changes.front());
        there.other.options = next->other.options;
    };
    enlarge("--bed", answers.bed, room.bed);
    enlarge("--size", answers.size, room.size);
    return there;
}

std::optional<Changed> changed(const Answers& answers, const std::string& option, const std::string& text) {
    for (const Question& q : questions()) {
        if (q.option != option || q.shown(answers) == text) continue;
        Answers other = answers;
        try {
            q.enter(other, text);
            require_consistent(other);
        } catch (const core::InvalidInput&) {
            return std::nullopt;
        }
        return Changed{other, {{{option, q.shown(other), q.shown(answers)}}, options_text(other)}};
    }
    return std::nullopt;
}

}  // namespace fusee::search::init
