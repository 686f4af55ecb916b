#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "page/column.h"
#include "page/html.h"
#include "page/svg_plot.h"
#include "simulation/page.h"

namespace fusee::report {

namespace {

using Level = SimulatedLevel;

constexpr const char* kPushAxis = "joint torque [Nm]";

/// One figure of each level over co-contraction.
struct OverLevels {
    const Simulation& simulation;
    std::vector<double> tau = column(simulation.levels, [](const Level& l) { return l.dead_band.tau; });
    [[nodiscard]] std::vector<double> figure(double SimulatedDeadBand::*member, double unit = 1.0) const {
        return column(simulation.levels, [=](const Level& l) { return unit * (l.dead_band.*member); });
    }
};

constexpr double kDegreesPerRadian = 180.0 / core::kPi;

std::string dead_band_chart(const Simulation& s, const OverLevels& over) {
    using D = SimulatedDeadBand;
    Plot plot("Dead-band at the joint, edge to edge", kCoContractionAxis, "dead-band [deg]");
    plot.curve("linear", over.tau, over.figure(&D::linear, kDegreesPerRadian), "linear", true);
    plot.curve("exact", over.tau, over.figure(&D::exact_width, kDegreesPerRadian), "exact");
    plot.curve("push and release", over.tau, over.figure(&D::measured_width, kDegreesPerRadian), "se");
    plot.curve("push within the laws", over.tau, column(s.levels, [](const Level& l) { return deg_from_rad(l.within_laws); }), "se", true);
    if (!s.measured.empty())
        plot.points("measured", column(s.measured, &MeasuredRow::tau),
                    column(s.measured, [](const MeasuredRow& r) { return deg_from_rad(r.measured); }), "pe");
    return plot.from_zero().svg();
}

std::string stiffness_chart(const OverLevels& over) {
    Plot plot("Stiffness of the joint", kCoContractionAxis, "stiffness [Nm/rad]");
    plot.curve("capstans held", over.tau, over.figure(&SimulatedDeadBand::joint_stiffness), "se");
    plot.curve("capstans free", over.tau, over.figure(&SimulatedDeadBand::free_joint_stiffness), "sum", true);
    return plot.from_zero().svg();
}

std::string built_chart(const Simulation& s, const OverLevels& over) {
    if (std::none_of(s.levels.begin(), s.levels.end(), [](const Level& l) { return std::isfinite(l.built.high); })) return "";
    Plot plot("Exact dead-band: nominal, and of 90 % of joints as built", kCoContractionAxis, "dead-band [deg]");
    plot.band("5 to 95 %", over.tau, column(s.levels, [](const Level& l) { return deg_from_rad(l.built.low); }),
              column(s.levels, [](const Level& l) { return deg_from_rad(l.built.high); }), "exact");
    plot.curve("nominal", over.tau, over.figure(&SimulatedDeadBand::exact_width, kDegreesPerRadian), "exact");
    return plot.from_zero().svg();
}

std::vector<double> torques_of(const std::vector<PathPoint>& path) { return column(path, &PathPoint::joint_torque); }
std::vector<double> angles_of(const std::vector<PathPoint>& path) {
    return column(path, [](const PathPoint& p) { return deg_from_rad(p.q); });
}

std::string loads_chart(const ReleasePath& path) {
    std::vector<PathPoint> whole = path.up;
    whole.insert(whole.end(), path.down.begin(), path.down.end());
    std::vector<double> step(whole.size());
    for (std::size_t i = 0; i < step.size(); ++i) step[i] = 4.0 * static_cast<double>(i) / static_cast<double>(step.size() - 1);
    const std::vector<double> ends{0.0, 4.0};
    const auto level = [](double load) { return std::vector<double>{load, load}; };
    Plot plot(fmt::format("Loads of both capstans at {} Nm: push up, release, push down, release", number(path.tau)), "stroke",
              "load [Nm]");
    plot.curve("agonist", step, column(whole, &PathPoint::load_1), "se");
    plot.curve("antagonist", step, column(whole, &PathPoint::load_2), "pe");
    plot.curve("least at rest", ends, level(path.resting_loads.low), "sum", true);
    plot.curve("greatest at rest", ends, level(path.resting_loads.high), "sum", true);
    return plot.svg();
}

std::string path_chart(const ReleasePath& path) {
    Plot plot(fmt::format("A push-and-release test at {} Nm", number(path.tau)), kPushAxis, "joint angle [deg]");
    plot.curve("up and released", torques_of(path.up), angles_of(path.up), "se");
    plot.curve("down and released", torques_of(path.down), angles_of(path.down), "pe");
    return plot.svg();
}

std::string loop_chart(const std::vector<DeflectionLoop>& loops) {
    static constexpr const char* kColours[] = {"linear", "t", "pe", "se"};
    Plot plot("Joint torque cycled, motor torques held", kPushAxis, "joint angle [deg]");
    for (std::size_t i = 0; i < loops.size(); ++i)
        plot.curve(number(loops[i].tau, 3) + " Nm", torques_of(loops[i].cycle), angles_of(loops[i].cycle),
                   kColours[i % std::size(kColours)]);
    return plot.svg();
}

std::string motor_chart(const std::vector<BreakAwayRow>& rows) {
    const auto motor = column(rows, &BreakAwayRow::motor_torque);
    Plot plot("Motor subsystem: loads at which the capstan breaks away", "motor torque at the capstan [Nm]", "load [Nm]");
    plot.curve("lowered", motor, column(rows, [](const BreakAwayRow& r) { return r.loads.low; }), "se");
    plot.curve("raised", motor, column(rows, [](const BreakAwayRow& r) { return r.loads.high; }), "pe");
    return plot.from_zero().svg();
}

std::string friction_chart(const std::vector<BreakAwayRow>& rows) {
    Plot plot("Motor subsystem: friction over load (figure 8)", "load at break-away [Nm]", "friction [Nm]");
    plot.curve("raised", column(rows, [](const BreakAwayRow& r) { return r.loads.high; }),
               column(rows, [](const BreakAwayRow& r) { return r.loads.high - r.motor_torque; }), "pe");
    return plot.from_zero().svg();
}

std::string frame_chart(const Simulation& s, const OverLevels& over) {
    Plot plot("Frame subsystem: dead-band with masses in place of motors", kCoContractionAxis, "dead-band [deg]");
    plot.curve("bearing only", over.tau, column(s.levels, [](const Level& l) { return deg_from_rad(l.frame); }), "se");
    plot.curve("with gears", over.tau, over.figure(&SimulatedDeadBand::measured_width, kDegreesPerRadian), "sum", true);
    return plot.from_zero().svg();
}

std::string deviation_chart(const Simulation& s, const OverLevels& over) {
    Plot plot("Passive noise rejection: standard deviation under white torque noise", kCoContractionAxis, "standard deviation [deg]");
    plot.curve("joint", over.tau, column(s.levels, [](const Level& l) { return deg_from_rad(l.noise[actuator::kOutput]); }), "se");
    plot.curve("capstans", over.tau, column(s.levels, [](const Level& l) { return deg_from_rad(l.noise[actuator::kAgonist]); }), "pe",
               true);
    return plot.from_zero().svg();
}

}  // namespace

std::string joint_charts(const Simulation& s) {
    const OverLevels over{s};
    Plot condition("Condition (6): below 0 stiction at the joint decreases", kCoContractionAxis, "d(T tau_f)/dtau [1]");
    condition.curve("d(T tau_f)/dtau", over.tau, over.figure(&SimulatedDeadBand::condition_6), "t").from_zero();
    return dead_band_chart(s, over) + condition.svg() + stiffness_chart(over) + built_chart(s, over);
}

std::string push_charts(const Simulation& s) {
    std::string out;
    if (s.path) out += path_chart(*s.path) + loads_chart(*s.path);
    return s.loops.empty() ? out : out + loop_chart(s.loops);
}

std::string subsystem_charts(const Simulation& s) {
    const OverLevels over{s};
    std::string out;
    if (!s.break_away.empty()) out += motor_chart(s.break_away) + friction_chart(s.break_away);
    return out + frame_chart(s, over) + deviation_chart(s, over);
}

}  // namespace fusee::report
