#include "repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "fusee/core/progress.h"
#include "fusee/design/evolution.h"
#include "fusee/pipeline/design.h"
#include "fusee/spring/potential.h"
#include "levers.h"
#include "reach.h"
#include "search.h"
#include "shapes.h"

namespace fusee::search::init {

namespace {

constexpr std::size_t kRows = 81;     // of the law that is written
constexpr std::size_t kTerms = 6;     // of the polynomial
constexpr double kMostChange = 0.6;   // of the greatest torque, for each term
constexpr double kBeyond = 0.03;      // of the asked angles: their edges move with the law
constexpr double kLongestStep = 1.0;  // of the measured angles: to continue farther is no measurement
constexpr double kFlattest = 0.05;    // least stiffness over the mean one
constexpr double kMargin = 1.02;      // of the bend, for the search that follows
constexpr int kRepairPopulation = 40, kRepairGenerations = 90, kScaleSteps = 20;
constexpr double kNoRepair = 1e3;  // cost of a law whose contour breaks a limit: above every change

using Terms = std::array<double, kTerms>;

/// A measured spring, beyond its angles continued with its stiffness there and the mean curvature of its last tenth, so that no contour has
/// a kink there; with a polynomial in s from -1 to 1 over `window` added.
class ChangedSpring final : public spring::Potential {
public:
    ChangedSpring(spring::PotentialPtr measured, core::Range window, const Terms& terms)
        : measured_(std::move(measured)), window_(window), terms_(terms) {}

    [[nodiscard]] core::Range domain() const override { return window_; }
    [[nodiscard]] double force(double x) const override { return continued(x, 0) + sum(x, 0); }
    [[nodiscard]] double stiffness(double x) const override { return continued(x, 1) + sum(x, 1); }
    [[nodiscard]] double slope(double x) const override { return continued(x, 2) + sum(x, 2); }
    [[nodiscard]] double energy(double x) const override { return continued(x, -1) + sum(x, -1); }

private:
    /// The measured torque, its derivatives or (-1) its integral.
    [[nodiscard]] double continued(double x, int order) const {
        const core::Range has = measured_->domain();
        const double end = std::clamp(x, has.low, has.high), step = x - end, tenth = 0.1 * has.width();
        if (step == 0.0 && order == 2) return measured_->slope(end);
        const double inside = end == has.low ? end + tenth : end - tenth;
        const double curvature = step == 0.0 ? 0.0 : (measured_->stiffness(end) - measured_->stiffness(inside)) / (end - inside);
        if (order == 2) return curvature;
        if (order == 1) return measured_->stiffness(end) + curvature * step;
        if (order == 0) return measured_->force(end) + step * (measured_->stiffness(end) + 0.5 * curvature * step);
        return measured_->energy(end) + step * (measured_->force(end) + step * (0.5 * measured_->stiffness(end) + curvature * step / 6.0));
    }
    /// The polynomial, its derivatives or (-1) its integral.
    [[nodiscard]] double sum(double x, int order) const {
        const double half = 0.5 * window_.width(), s = (x - window_.low) / half - 1.0;
        double total = 0.0;
        for (std::size_t i = 0; i < kTerms; ++i) {
            const double n = static_cast<double>(i);
            if (order < 0) total += terms_[i] * half * (std::pow(s, n + 1.0) - std::pow(-1.0, n + 1.0)) / (n + 1.0);
            if (order == 0) total += terms_[i] * std::pow(s, n);
            if (order == 1 && i >= 1) total += terms_[i] * n * std::pow(s, n - 1.0) / half;
            if (order == 2 && i >= 2) total += terms_[i] * n * (n - 1.0) * std::pow(s, n - 2.0) / (half * half);
        }
        return total;
    }

    spring::PotentialPtr measured_;
    core::Range window_;
    Terms terms_;
};

/// Both springs of the file over the window.
struct Pair {
    spring::PotentialPtr series, parallel;
    core::Range window;  ///< [rad]

    [[nodiscard]] const spring::PotentialPtr& of(cam::PartKind part) const { return part == cam::PartKind::kSeries ? series : parallel; }
};

/// Candidates of one part: numbers of `Scale`, then the terms of its polynomial.
class Candidates {
public:
    Candidates(cam::PartKind part, const Answers& answers, Pair pair)
        : part_(part), answers_(answers), pair_(std::move(pair)), variables_(variables_of(answers)), start_(start_of(answers)) {
        for (std::size_t i = 0; i < kRows; ++i) greatest_ = std::max(greatest_, pair_.of(part)->force(pair_.window.level(i, kRows)));
    }

    [[nodiscard]] std::vector<core::Range> bounds() const {
        std::vector<core::Range> all = bounds_of(variables_);
        all.insert(all.end(), kTerms, {-kMostChange, kMostChange});
        return all;
    }
    [[nodiscard]] spring::PotentialPtr spring(std::span<const double> x) const {
        Terms terms{};
        for (std::size_t i = 0; i < kTerms; ++i) terms[i] = greatest_ * x[variables_.size() + i];
        return std::make_shared<ChangedSpring>(pair_.of(part_), pair_.window, terms);
    }
    /// Root mean square of the change over the greatest torque, or how far a limit is broken.
    [[nodiscard]] double operator()(std::span<const double> x) const {
        const spring::PotentialPtr spring = this->spring(x);
        const double mean = (spring->force(pair_.window.high) - spring->force(pair_.window.low)) / pair_.window.width();
        double squares = 0.0, flat = 0.0;
        for (std::size_t i = 0; i < kRows; ++i) {
            const double at = pair_.window.level(i, kRows), change = (spring->force(at) - pair_.of(part_)->force(at)) / greatest_;
            squares += change * change / static_cast<double>(kRows);
            flat = std::max({flat, kFlattest - spring->stiffness(at) / std::abs(mean), -spring->force(at) / greatest_});
        }
        if (!(flat <= 0.0)) return 3.0 * kNoRepair * (1.0 + std::min(flat, 1e3));
        const double broken = contour_excess(x, spring);
        return broken > 0.0 ? kNoRepair * (1.0 + std::min(broken, 1.9)) : std::sqrt(squares);
    }

private:
    [[nodiscard]] double contour_excess(std::span<const double> x, const spring::PotentialPtr& spring) const {
        const profile::Profile p = scaled("init", answers_, entered(start_, variables_, x.first(variables_.size())));
        const bool series = part_ == cam::PartKind::kSeries;
        const spring::PotentialPtr& one = series ? spring : pair_.series;
        const spring::PotentialPtr& two = series ? pair_.parallel : spring;
        const auto load = [&](double at) { return one->force(at) + two->force(at); };
        const auto law = spring::make_pair_law(one, two, load(pair_.window.low), load(pair_.window.high));
        if (!law) return 1.9;
        const profile::PartSpec& spec = p.part(part_);
        const cam::ArmFunction arm(part_, *law, spec.spring, p.rig.capstan_radius, spec.allowance);
        return broken_share(codesign::shape_of(arm, spec.cam), answers_, kMargin);
    }

    cam::PartKind part_;
    const Answers& answers_;
    Pair pair_;
    std::vector<Variable<Scale>> variables_;
    Scale start_;
    double greatest_ = 0.0;  ///< torque of the measured spring [Nm]
};

/// The nearest spring of one part; none if none was found.
std::optional<spring::PotentialPtr> nearest_spring(cam::PartKind part, const Answers& answers, const Pair& pair,
                                                   const InitOptions& options) {
    const Candidates candidates(part, answers, pair);
    design::EvolutionOptions evolution;
    evolution.bounds = candidates.bounds();
    evolution.population = kRepairPopulation;
    evolution.generations = kRepairGenerations;
    evolution.jobs = options.jobs;
    evolution.stop = [&] { return options.stop && options.stop(); };
    design::EvolutionResult found = design::evolve(std::cref(candidates), evolution);
    if (options.stop && options.stop()) throw core::Stopped();
    if (found.cost >= kNoRepair) return std::nullopt;
    // Less of the same change, as long as the limits hold.
    std::vector<double> best = found.best;
    for (int i = kScaleSteps - 1; i >= 0; --i) {
        std::vector<double> less = found.best;
        for (std::size_t k = less.size() - kTerms; k < less.size(); ++k) less[k] *= static_cast<double>(i) / kScaleSteps;
        if (candidates(less) >= kNoRepair) break;
        best = less;
    }
    return candidates.spring(best);
}

/// The measured springs continued to the asked angles; none if that is longer than the measurement, or no pair of springs.
std::optional<Pair> continued_pair(const Answers& answers) {
    const profile::TablePair& rows = *answers.law;
    const auto law = MeasuredLaw::of(rows);
    if (!law) return std::nullopt;
    const core::Range has = law->angles(), asked = law->asked(answers).angles;
    const double margin = kBeyond * (asked.high - asked.low);
    const core::Range window{asked.low < has.low ? asked.low - margin : has.low, asked.high > has.high ? asked.high + margin : has.high};
    if (!(window.width() <= (1.0 + kLongestStep) * has.width())) return std::nullopt;
    const auto longer = [&](const std::vector<double>& torques) {
        return std::make_shared<ChangedSpring>(spring::make_tabulated(rows.angle, torques, rows.smoothing), window, Terms{});
    };
    const Pair pair{longer(rows.series), longer(rows.parallel), window};
    for (const spring::PotentialPtr& s : {pair.series, pair.parallel})
        for (const double end : {window.low, window.high})
            if (!(s->force(end) > 0.0) || !(s->stiffness(end) > 0.0)) return std::nullopt;  // a cable cannot push
    return pair;
}

Repair::Change change_of(const std::vector<double>& now, const std::vector<double>& wanted) {
    Repair::Change change;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const double step = now[i] - wanted[i];
        change.least = std::min(change.least, step);
        change.greatest = std::max(change.greatest, step);
        change.mean += step * step / static_cast<double>(now.size());
    }
    change.mean = std::sqrt(change.mean);
    return change;
}

}  // namespace

Repair::Change Repair::series_change() const { return change_of(law.series, wanted_series); }
Repair::Change Repair::parallel_change() const { return change_of(law.parallel, wanted_parallel); }

std::string repair_csv(const Repair& repair) {
    std::string text = "angle_rad,series_Nm,parallel_Nm,wanted_series_Nm,wanted_parallel_Nm,measured\n";
    for (std::size_t i = 0; i < repair.law.angle.size(); ++i)
        text += fmt::format("{},{},{},{},{},{}\n", repair.law.angle[i], repair.law.series[i], repair.law.parallel[i],
                            repair.wanted_series[i], repair.wanted_parallel[i], repair.measured.holds(repair.law.angle[i]) ? 1 : 0);
    return text;
}

std::optional<Repair> find_repair(const Answers& answers, const InitOptions& options) {
    const auto wanted = continued_pair(answers);
    if (!wanted) return std::nullopt;
    Repair repair;
    repair.measured = {std::max(answers.law->angle.front(), wanted->window.low), std::min(answers.law->angle.back(), wanted->window.high)};
    Pair now = *wanted;
    const auto enter = [&] {
        repair.law = *answers.law;
        repair.law.smoothing = {};
        repair.law.angle.clear(), repair.law.series.clear(), repair.law.parallel.clear();
        for (std::size_t i = 0; i < kRows; ++i) {
            repair.law.angle.push_back(now.window.level(i, kRows));
            repair.law.series.push_back(now.series->force(repair.law.angle.back()));
            repair.law.parallel.push_back(now.parallel->force(repair.law.angle.back()));
        }
        Answers repaired = answers;
        repaired.law = repair.law;
        return repaired;
    };
    const Answers longer = enter();
    for (const core::Finding& f : broken_contours(longer, options.jobs)) {
        const cam::PartKind part = f.where == to_string(cam::PartKind::kSeries) ? cam::PartKind::kSeries : cam::PartKind::kParallel;
        auto nearest = nearest_spring(part, longer, now, options);
        if (!nearest) return std::nullopt;
        (part == cam::PartKind::kSeries ? now.series : now.parallel) = *nearest;
    }
    if (!broken_at_once(enter(), options).empty()) return std::nullopt;
    for (const double angle : repair.law.angle) {
        repair.wanted_series.push_back(wanted->series->force(angle));
        repair.wanted_parallel.push_back(wanted->parallel->force(angle));
    }
    return repair;
}

}  // namespace fusee::search::init
