#include "search.h"

#include <algorithm>
#include <cmath>

#include "codesign/shape.h"
#include "fusee/checks/limits.h"
#include "fusee/core/progress.h"
#include "fusee/design/evolution.h"
#include "fusee/pipeline/evaluate.h"
#include "reach.h"

namespace fusee::search::init {

namespace {

using core::Range;

constexpr int kPopulation = 32;
constexpr int kPatience = 10, kLongPatience = 40, kShortPatience = 20;  // generations without progress: with a design, without one
constexpr double kLeastGain = 0.01;                                     // of the cost, relative: less is no progress
constexpr double kErrors = 1e6, kWarnings = 1e3;                        // cost of a broken limit: above every cost of the step below it
constexpr double kDegreesPerSize = 2.0;  // cam and capstan larger by ten cable diameters are worth so many degrees of dead-band
constexpr Range kStartOfMeasured{0.85, 0.999}, kEndOfMeasured{1.001, 1.06};  // of the loads that a measured law is asked
constexpr double kNoDemand = 1e-6, kAnySoftness = 1e9;
constexpr double kRoomForSprings = 0.98;  // of the wanted size: the springs that are wound then change the contours a little
constexpr double kLip = 1.0;              // of a groove over the cable's centreline, in cable diameters: 1.5 deep, floor 0.53 below
constexpr double kEdgeOfBed = 10e-3;      // lips and flanges beyond the contour, and the edge of the bed [m]

Variable<Scale> as_it_is(double Scale::*member, Range box) {
    return {"", "", box, [member](Scale& scale, double x) { scale.*member = x; }};
}
Variable<Scale> by_logarithm(double Scale::*member, Range box) {
    return {"", "", {std::log(box.low), std::log(box.high)}, [member](Scale& scale, double x) { scale.*member = std::exp(x); }};
}

/// Radius of curvature of a cable's centreline at this D/d [m].
double radius_of(double ratio, const profile::Profile& p) { return 0.5 * (ratio + 1.0) * p.cable.diameter; }

/// The demands of a first profile: none on travel, since the law keeps its shape; sizes that the machine makes.
profile::Profile demanding(profile::Profile p, const Answers& answers) {
    design::CoDesignOptions& o = p.co_design;
    o.torques = {p.rig.peak_torque, p.rig.overdrive_torque};
    o.loads = {p.rig.least_torque, p.rig.overdrive_torque};
    o.travel = o.stiff = kNoDemand;
    o.soft = kAnySoftness;
    o.reviews = design::Reviews::kAccept;
    o.least_rho_se = o.least_rho_pe = radius_of(checks::cable_limits(p.cable.construction).critical, p);
    o.contour_radius = contour_limit(answers);
    return p;
}

/// Diameter of the larger one of capstan and joint's pulley, with its cable [m].
double pulley_size(const profile::Profile& p) { return 2.0 * (std::max(p.rig.capstan_radius, p.rig.joint_radius) + p.cable.diameter); }

/// Costs of candidates: errors first, then warnings, then dead-band and size.
class Costs {
public:
    Costs(const std::string& name, const Answers& answers)
        : name_(name),
          answers_(answers),
          start_(start_of(answers)),
          variables_(variables_of(answers)),
          problem_(demanding(scaled(name, answers, start_), answers)) {}

    [[nodiscard]] std::vector<Range> bounds() const { return bounds_of(variables_); }
    [[nodiscard]] profile::Profile candidate(std::span<const double> x) const {
        return scaled(name_, answers_, entered(start_, variables_, x));
    }
    [[nodiscard]] codesign::Trial errors(const profile::Profile& p) const { return problem_.evaluate(p); }

    [[nodiscard]] double operator()(std::span<const double> x) const {
        const profile::Profile p = candidate(x);
        const codesign::Trial trial = problem_.evaluate(p);
        const codesign::Trial strict =
            codesign::avoiding_reviews(trial, radius_of(checks::cable_limits(p.cable.construction).recommended, p));
        const double widest = std::max(pulley_size(p), 2.0 * (strict.radius + kLip * p.cable.diameter));
        const double wide = std::max(0.0, widest / (kRoomForSprings * answers_.largest_size()) - 1.0);
        if (!trial.feasible() || wide > 0.0) return kErrors * (1.0 + trial.violation + wide);
        if (!strict.feasible()) return kWarnings * (1.0 + strict.violation);
        const double size = strict.radius + p.rig.capstan_radius;
        return core::deg_from_rad(trial.figure) + kDegreesPerSize * size / (10.0 * p.cable.diameter);
    }

private:
    std::string name_;
    Answers answers_;
    Scale start_;
    std::vector<Variable<Scale>> variables_;
    codesign::Problem problem_;
};

/// Counts the generations without progress; the same on any number of threads.
class Rest {
public:
    explicit Rest(int long_patience) : long_patience_(long_patience) {}
    void note(double best) {
        const bool better = best < (1.0 - kLeastGain) * best_;
        idle_ = better ? 0 : idle_ + 1;
        if (better) best_ = best;
    }
    /// Share of the generations after which a search rests: more while no design can be made.
    [[nodiscard]] double share() const { return static_cast<double>(idle_) / (best_ < kErrors ? kPatience : long_patience_); }

private:
    int long_patience_, idle_ = 0;
    double best_ = INFINITY;
};

/// Limits of the search, the worst first, then errors of the rules.
core::Findings binding_limits(const codesign::Trial& trial, const profile::Profile& profile, const Answers& answers) {
    core::Findings findings = codesign::broken(trial);
    core::append(findings, too_large(profile, answers));
    std::erase_if(findings, [](const core::Finding& f) {
        return !f.rule.starts_with("limit.") && !f.rule.starts_with("cover.") && !f.rule.starts_with("demand.") &&
               !f.rule.starts_with("law.");
    });
    for (core::Finding& f : findings) f.suggestion.clear();  // keys of a search that nobody has written
    for (const core::Finding& f : pipeline::evaluate(profile, pipeline::Depth::kOutline).all())
        if (f.severity == core::Severity::kError) findings.push_back(f);
    return findings;
}

}  // namespace

std::vector<Variable<Scale>> variables_of(const Answers& answers) {
    const Sizes sizes = least_sizes(answers);
    std::vector<Variable<Scale>> all{by_logarithm(&Scale::k_pe, {0.7 * sizes.k_pe, 6.0 * sizes.k_pe}),
                                     by_logarithm(&Scale::k_se, {0.8 * sizes.k_se, 4.0 * sizes.k_se}),
                                     by_logarithm(&Scale::capstan, {0.35, 1.1}),
                                     by_logarithm(&Scale::preload_pe, {0.05, 1.3}),
                                     by_logarithm(&Scale::preload_se, {0.3, 0.9}),
                                     as_it_is(&Scale::start, answers.law ? kStartOfMeasured : Range{0.8, 0.98}),
                                     as_it_is(&Scale::end, answers.law ? kEndOfMeasured : Range{1.01, 1.15})};
    if (answers.law) return all;
    all.insert(all.end(), {by_logarithm(&Scale::softness, {0.6, 1.4}), as_it_is(&Scale::transmission, {0.25, 0.7}),
                           as_it_is(&Scale::u_share, {0.0, 0.2})});
    return all;
}

Scale start_of(const Answers& answers) {
    Scale scale;
    if (!answers.law) return scale;
    const auto law = MeasuredLaw::of(*answers.law);
    scale.asked = law->asked(answers).loads;
    scale.carried = law->loads();
    return scale;
}

double contour_limit(const Answers& answers) {
    return std::min(0.5 * answers.bed - kEdgeOfBed, 0.5 * answers.largest_size() - kLip * answers.cable);
}

core::Findings too_large(const profile::Profile& profile, const Answers& answers) {
    core::Findings findings;
    const auto require = [&](double size, const std::string& what, const std::string& where) {
        if (size <= answers.largest_size()) return;
        findings.push_back(core::error_finding("limit.size", what, core::mm_from_m(size), core::Bound::kAtMost,
                                               core::mm_from_m(answers.largest_size()), "mm"));
        findings.back().where = where;
    };
    require(pulley_size(profile), "diameter of the larger one of capstan and joint's pulley, with its cable", "rig");
    const auto design = pipeline::resolve_for_search(profile);
    for (const cam::PartKind part : {cam::PartKind::kSeries, cam::PartKind::kParallel})
        if (const auto cam = design ? pipeline::design_cam(part, *design) : core::Outcome<cam::Cam>(core::Findings{}))
            require(2.0 * (codesign::contour_radius(*cam) + kLip * profile.cable.diameter), "diameter of the cam, with its lips",
                    to_string(part));
    return findings;
}

Room room_for(double contour_radius, const Answers& answers) {
    return {2.0 * (contour_radius + kEdgeOfBed), 2.0 * (contour_radius + kLip * answers.cable)};
}

Searched search_scales(const std::string& name, const Answers& answers, const Effort& effort, const InitOptions& options) {
    const Costs costs(name, answers);
    Rest rest(effort.first ? kShortPatience : kLongPatience);
    bool makeable = false;
    double hope = 0.0;  // share of the generations that it may take to the first design
    design::EvolutionOptions evolution;
    evolution.bounds = costs.bounds();
    evolution.population = kPopulation;
    evolution.generations = effort.generations;
    evolution.seed = effort.seed;
    evolution.jobs = options.jobs;
    evolution.progress = [&](int generation, double best) {
        rest.note(best);
        makeable = best < kErrors;
        hope = makeable ? 0.0 : double(generation) / effort.hopeless;
        const double share = std::max({double(generation) / effort.generations, rest.share(), hope});
        if (options.progress) options.progress(share, best < kErrors ? "smaller dead-band and size" : "cams that the rules pass");
    };
    evolution.stop = [&] { return (options.stop && options.stop()) || std::max(rest.share(), hope) >= 1.0 || (effort.first && makeable); };
    const design::EvolutionResult found = design::evolve(std::cref(costs), evolution);
    if (options.stop && options.stop()) throw core::Stopped();
    Searched searched{costs.candidate(found.best), found.cost < kErrors, {}, 0.0, found.evaluations};
    if (searched.makeable) return searched;
    searched.missing = found.cost / kErrors - 1.0;
    searched.binding = binding_limits(costs.errors(searched.profile), searched.profile, answers);
    return searched;
}

}  // namespace fusee::search::init
