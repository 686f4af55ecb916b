#include "figures.h"

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/simulate.h"
#include "fusee/spring/potential.h"

namespace fusee::paper {

namespace {

constexpr int kPoints = 81;

NoiseCurve noise_curve(const std::string& name, const actuator::NoisePath& path) {
    constexpr double kSoftest = 0.01, kDecades = 4.0;
    NoiseCurve curve;
    curve.name = name;
    curve.path = path;
    for (int i = 0; i < kPoints; ++i) {
        actuator::NoisePath at = path;
        at.c = kSoftest * std::pow(10.0, kDecades * i / (kPoints - 1));
        const auto response = actuator::passive_noise(at);
        const auto slope = actuator::joint_variance_slope(at);
        if (!response || !slope) {
            curve.refusal = core::to_line((response ? slope.refusal() : response.refusal()).front());
            return curve;
        }
        curve.c.push_back(at.c);
        curve.motor.push_back(response->motor_variance);
        curve.joint.push_back(response->joint_variance);
        curve.slope.push_back(*slope);
    }
    return curve;
}

/// Both arrangements of one linear muscle over its stretch, for three active forces up to `strongest`.
std::vector<HillFigure::Row> muscle_rows(const HillFigure& figure, double longest, double strongest) {
    constexpr int kForces = 3, kLengths = 41;
    std::vector<HillFigure::Row> rows;
    for (int i = 0; i < kForces; ++i)
        for (int j = 0; j < kLengths; ++j) {
            const double active = strongest * i / (kForces - 1), length = longest * j / (kLengths - 1);
            const double contractile = contractile_from_active(figure.series, length, active);
            rows.push_back(
                {active, length, series_force(figure.series, length, active), parallel_force(figure.parallel, length, contractile)});
        }
    return rows;
}

std::vector<HillFigure::Passive> passive_curve(const spring::Potential& tension) {
    std::vector<HillFigure::Passive> curve;
    const core::Range domain = tension.domain();
    for (int i = 0; i < kPoints; ++i) {
        const double length = domain.low + domain.width() * i / (kPoints - 1);
        curve.push_back({length, tension.force(length)});
    }
    return curve;
}

/// Capstan travel over the measured rows: dtheta/dtau = 1/(S + P), about 1/P where T is small. Between two rows tau/P, in proportion to
/// the width for tau_f = mu tau, is taken as a + b tau.
double implied_travel(const std::vector<pipeline::MeasuredRow>& rows, const std::vector<double>& parallel) {
    double travel = 0.0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double from = rows[i - 1].tau, to = rows[i].tau;
        const double slope = (to / parallel[i] - from / parallel[i - 1]) / (to - from);
        travel += (from / parallel[i - 1] - slope * from) * std::log(to / from) + slope * (to - from);
    }
    return travel;
}

}  // namespace

std::vector<NoiseCurve> noise_figure() {
    const actuator::NoisePath both{
        .a = 1, .b = 1, .d = 0.5, .e = 0.5, .motor_inertia = 1, .joint_inertia = 1, .motor_noise = 1, .joint_noise = 1};
    actuator::NoisePath motor = both, joint = both, hanging = both, floating = both;
    motor.joint_noise = 0;
    joint.motor_noise = 0;
    hanging.a = 0;
    floating.a = floating.b = 0;
    return {noise_curve("both bodies", both), noise_curve("the joint alone", joint), noise_curve("the motor alone", motor),
            noise_curve("both bodies with a = 0", hanging), noise_curve("both bodies with a = b = 0", floating)};
}

core::Outcome<HillFigure> hill_figure(const profile::Profile& profile) {
    const auto design = pipeline::resolve(profile);
    if (!design) return design.refusal();
    const spring::LawPoint peak = design->law()->at_load(profile.rig.peak_torque);
    HillFigure figure;
    figure.series = {.k_se = peak.s, .k_pe = peak.p};
    figure.parallel = parallel_from_series(figure.series);
    figure.rows = muscle_rows(figure, peak.theta, peak.tau);
    figure.passive = passive_curve(*passive_tension(spring::series_spring(design->law()), spring::parallel_spring(design->law())));
    return figure;
}

core::Outcome<PaperTable> replay_table(const profile::Profile& profile) {
    if (profile.simulate.measured.x.empty())
        throw core::InvalidInput(profile.place_of("simulate.measured"), "none", "the rows of the paper's table");
    auto simulation = pipeline::simulate(profile);
    if (!simulation) return simulation.refusal();
    PaperTable table;
    table.simulation = std::move(simulation).value();
    const spring::FrictionLaw gear = pipeline::gear_friction(profile);
    const double ratio = profile.rig.joint_radius / profile.rig.capstan_radius;
    for (const pipeline::MeasuredRow& row : table.simulation.measured)
        table.parallel.push_back(2.0 * gear.at_rest(row.tau) / (ratio * row.measured));  // docs/theory/dead_band.md, eq. 2
    table.travel = implied_travel(table.simulation.measured, table.parallel);
    return table;
}

}  // namespace fusee::paper
