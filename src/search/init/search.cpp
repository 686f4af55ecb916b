#include "search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fusee/checks/limits.h"
#include "fusee/core/progress.h"
#include "fusee/design/evolution.h"
#include "fusee/pipeline/evaluate.h"
#include "variables.h"

namespace fusee::search::init {

namespace {

using core::Range;

constexpr int kPopulation = 32;
constexpr int kPatience = 10, kLongPatience = 40;  // generations without progress: with a design that can be made, without one
constexpr double kLeastGain = 0.01;                // of the cost, relative: less is no progress
constexpr double kErrors = 1e6, kWarnings = 1e3;   // cost of a broken limit: above every cost of the step below it
constexpr double kDegreesPerSize = 2.0;            // cam and capstan larger by ten cable diameters are worth so many degrees of dead-band
constexpr double kNoDemand = 1e-6, kAnySoftness = 1e9;
constexpr double kEdgeOfBed = 10e-3;  // lips and flanges beyond the contour, and the edge of the bed [m]

Variable<Scale> as_it_is(double Scale::*member, Range box) {
    return {"", "", box, [member](Scale& scale, double x) { scale.*member = x; }};
}
Variable<Scale> by_logarithm(double Scale::*member, Range box) {
    return {"", "", {std::log(box.low), std::log(box.high)}, [member](Scale& scale, double x) { scale.*member = std::exp(x); }};
}

std::vector<Variable<Scale>> variables_of(const Answers& answers) {
    const Sizes sizes = least_sizes(answers);
    std::vector<Variable<Scale>> all{by_logarithm(&Scale::k_pe, {0.7 * sizes.k_pe, 6.0 * sizes.k_pe}),
                                     by_logarithm(&Scale::k_se, {0.8 * sizes.k_se, 4.0 * sizes.k_se}),
                                     by_logarithm(&Scale::capstan, {0.35, 1.1}),
                                     by_logarithm(&Scale::preload_pe, {0.05, 1.3}),
                                     by_logarithm(&Scale::preload_se, {0.3, 0.9}),
                                     as_it_is(&Scale::start, {0.8, 0.98}),
                                     as_it_is(&Scale::end, {1.01, 1.15})};
    if (answers.law) return all;
    all.insert(all.end(), {by_logarithm(&Scale::softness, {0.6, 1.4}), as_it_is(&Scale::transmission, {0.25, 0.7}),
                           as_it_is(&Scale::u_share, {0.0, 0.2})});
    return all;
}

/// The demands of a first profile: none on travel, since the law keeps its shape; sizes that the machine makes.
profile::Profile demanding(profile::Profile p, design::Reviews reviews) {
    design::CoDesignOptions& o = p.co_design;
    const checks::CableLimits& cable = checks::cable_limits(p.cable.construction);
    const double ratio = reviews == design::Reviews::kAvoid ? cable.recommended : cable.critical;
    o.torques = {p.rig.peak_torque, p.rig.overdrive_torque};
    o.loads = {p.rig.least_torque, p.rig.overdrive_torque};
    o.travel = o.stiff = kNoDemand;
    o.soft = kAnySoftness;
    o.reviews = reviews;
    o.least_rho_se = o.least_rho_pe = 0.5 * (ratio + 1.0) * p.cable.diameter;
    o.contour_radius = 0.5 * std::min(p.process.build_x, p.process.build_y) - kEdgeOfBed;
    return p;
}

/// Costs of candidates: errors first, then warnings, then dead-band and size.
class Costs {
public:
    Costs(const std::string& name, const Answers& answers)
        : name_(name),
          answers_(answers),
          variables_(variables_of(answers)),
          errors_(demanding(scaled(name, answers, {}), design::Reviews::kAccept)),
          warnings_(demanding(scaled(name, answers, {}), design::Reviews::kAvoid)) {}

    [[nodiscard]] std::vector<Range> bounds() const { return bounds_of(variables_); }
    [[nodiscard]] profile::Profile candidate(std::span<const double> x) const {
        return scaled(name_, answers_, entered(Scale{}, variables_, x));
    }
    [[nodiscard]] codesign::Trial errors(const profile::Profile& p) const { return errors_.evaluate(p); }

    [[nodiscard]] double operator()(std::span<const double> x) const {
        const profile::Profile p = candidate(x);
        const codesign::Trial warnings = warnings_.evaluate(p);
        if (!warnings.feasible()) {
            const codesign::Trial errors = errors_.evaluate(p);
            return errors.feasible() ? kWarnings * (1.0 + warnings.violation) : kErrors * (1.0 + errors.violation);
        }
        const double size = warnings.radius + p.rig.capstan_radius;
        return core::deg_from_rad(warnings.figure) + kDegreesPerSize * size / (10.0 * p.cable.diameter);
    }

private:
    std::string name_;
    Answers answers_;
    std::vector<Variable<Scale>> variables_;
    codesign::Problem errors_, warnings_;
};

/// Counts the generations without progress; the same on any number of threads.
class Rest {
public:
    void note(double best) {
        const bool better = best < (1.0 - kLeastGain) * best_;
        idle_ = better ? 0 : idle_ + 1;
        if (better) best_ = best;
    }
    /// Share of the generations after which a search rests: more while no design can be made.
    [[nodiscard]] double share() const { return static_cast<double>(idle_) / (best_ < kErrors ? kPatience : kLongPatience); }

private:
    int idle_ = 0;
    double best_ = INFINITY;
};

/// Limits of the search, the worst first, then errors of the rules.
core::Findings binding_limits(const codesign::Trial& trial, const profile::Profile& profile) {
    core::Findings findings = codesign::broken(trial);
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

Searched search_scales(const std::string& name, const Answers& answers, const Effort& effort, const Options& options) {
    const Costs costs(name, answers);
    Rest rest;
    bool makeable = false;
    design::EvolutionOptions evolution;
    evolution.bounds = costs.bounds();
    evolution.population = kPopulation;
    evolution.generations = effort.generations;
    evolution.seed = effort.seed;
    evolution.jobs = options.jobs;
    evolution.progress = [&](int generation, double best) {
        rest.note(best);
        makeable = best < kErrors;
        const double share = std::max(double(generation) / effort.generations, rest.share());
        if (options.progress) options.progress(share, best < kErrors ? "smaller dead-band and size" : "cams that the rules pass");
    };
    evolution.stop = [&] { return (options.stop && options.stop()) || rest.share() >= 1.0 || (effort.first && makeable); };
    const design::EvolutionResult found = design::evolve(std::cref(costs), evolution);
    if (options.stop && options.stop()) throw core::Stopped();
    Searched searched{costs.candidate(found.best), found.cost < kErrors, {}, found.evaluations};
    if (!searched.makeable) searched.binding = binding_limits(costs.errors(searched.profile), searched.profile);
    return searched;
}

}  // namespace fusee::search::init
