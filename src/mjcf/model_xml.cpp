#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "fusee/core/text.h"
#include "fusee/mjcf/write.h"

namespace fusee::mjcf {

namespace {

constexpr std::array<const char*, 2> kNames{"agonist", "antagonist"};
/// MuJoCo softens every constraint: this is the hardest friction that it accepts. What remains is a creep of 1e-4 of the friction.
constexpr double kHardest = 0.9999;
/// So far below its free length a tendon never gets [rad].
constexpr double kSlack = 1e4;

/// The two angles as pictured: capstans left and right of the joint, three capstan radii away.
constexpr double kApart = 3.0;

/// Text inside an XML comment, which may not hold two hyphens in a row.
std::string comment(std::string text) {
    for (std::size_t at = 0; (at = text.find("--", at)) != std::string::npos; ++at) text.insert(at + 1, " ");
    return text;
}

std::string spring_comment(const char* what, const Cubic& fit, const Curve& curve) {
    return fmt::format("    <!-- {}: worst error of the cubic {:.3g} Nm ({:.3g} % of the greatest torque) at {:.4g} rad -->\n", what,
                       fit.worst, 100.0 * fit.worst / curve.greatest(), fit.worst_at);
}

std::string tendon(const std::string& name, const Curve& curve, const std::string& arms) {
    const Cubic fit = fit_cubic(curve);
    return spring_comment(name.c_str(), fit, curve) +
           fmt::format("    <fixed name=\"{}\" springlength=\"{:.10g} {:.10g}\" stiffness=\"{:.10g} {:.10g} {:.10g}\">{}</fixed>\n", name,
                       fit.free - kSlack, fit.free, fit.linear, fit.square, fit.cube, arms);
}

std::string arm(const char* joint, double coef) { return fmt::format("<joint joint=\"{}\" coef=\"{:.10g}\"/>", joint, coef); }

std::string tendons(const Twin& twin) {
    std::string text = "  <tendon>\n";
    for (std::size_t i = 0; i < 2; ++i) {
        const char* const name = kNames[i];
        const TwinSide& side = twin.sides[i];
        const double g = i == 0 ? side.ratio : -side.ratio;
        text += tendon(fmt::format("k_se_{}", name), side.se, arm(name, side.capstan_scale) + arm("joint", g));
        text += tendon(fmt::format("k_pe_{}", name), side.pe, arm(name, 1.0));
    }
    return text + "  </tendon>\n";
}

/// A capstan at rest under the reference torque carries it: the friction that it has there.
std::string capstan(const Twin& twin, std::size_t i) {
    const TwinGear& gear = twin.sides[i].gear;
    return fmt::format(
        "    <body name=\"capstan_{0}\" pos=\"{1:.6g} 0 0\">\n"
        "      <inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"{2:.10g} {2:.10g} {2:.10g}\"/>\n"
        "      <joint name=\"{0}\" type=\"hinge\" axis=\"0 0 {3}\" damping=\"{4:.10g}\" frictionloss=\"{5:.10g}\"{6}/>\n"
        "      <geom type=\"cylinder\" size=\"{7:.6g} {8:.6g}\" rgba=\".75 .5 .25 1\"/>\n"
        "      <geom type=\"box\" pos=\"{9:.6g} 0 {8:.6g}\" size=\"{9:.6g} {10:.6g} {10:.6g}\" rgba=\".2 .2 .2 1\"/>\n"
        "    </body>\n",
        kNames[i], (i == 0 ? -kApart : kApart) * twin.capstan_radius, twin.sides[i].motor_inertia, i == 0 ? 1 : -1, gear.viscous,
        gear.at(twin.reference_torque), twin.capstan_stops ? fmt::format(" range=\"0 {}\"", kSlack) : "", twin.capstan_radius,
        0.2 * twin.capstan_radius, 0.4 * twin.capstan_radius, 0.05 * twin.capstan_radius);
}

/// The series springs' torque at the joint under the reference torque: what its bearing carries there.
double joint_friction(const Twin& twin) {
    double tension = 0.0;
    for (const TwinSide& side : twin.sides) {
        double low = side.se.low, high = side.se.high;
        for (int i = 0; i < 60; ++i) {  // halves the bracket of the capstan's angle at that load
            const double middle = 0.5 * (low + high);
            (side.se.at(side.capstan_scale * middle) + side.pe.at(middle) < twin.reference_torque ? low : high) = middle;
        }
        tension += side.ratio * side.se.at(side.capstan_scale * low);
    }
    return twin.joint_friction + twin.tension_share * tension;
}

std::string output(const Twin& twin) {
    const double radius = 0.5 * (twin.sides[0].ratio + twin.sides[1].ratio) * twin.capstan_radius;  // as pictured
    const std::string range = std::isfinite(twin.stop) ? fmt::format(" range=\"{:.10g} {:.10g}\"", -twin.stop, twin.stop) : "";
    return fmt::format(
        "    <body name=\"output\">\n"
        "      <inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"{0:.10g} {0:.10g} {0:.10g}\"/>\n"
        "      <joint name=\"joint\" type=\"hinge\" axis=\"0 0 1\" damping=\"{1:.10g}\" frictionloss=\"{2:.10g}\"{3}/>\n"
        "      <geom type=\"cylinder\" size=\"{4:.6g} {5:.6g}\" rgba=\".3 .5 .75 1\"/>\n"
        "      <geom type=\"box\" pos=\"0 {6:.6g} 0\" size=\"{5:.6g} {6:.6g} {5:.6g}\" rgba=\".3 .5 .75 1\"/>\n"
        "    </body>\n",
        twin.joint_inertia, twin.joint_viscous, joint_friction(twin), range, radius, 0.2 * twin.capstan_radius, 2.0 * radius);
}

std::string motor(const char* name, double scale, double saturation) {
    const std::string limit =
        std::isfinite(saturation) ? fmt::format(" forcelimited=\"true\" forcerange=\"{:.10g} {:.10g}\"", -saturation, saturation) : "";
    return fmt::format("    <general name=\"torque_{0}\" joint=\"{0}\" gainprm=\"{1:.10g}\"{2}/>\n", name, scale, limit);
}

std::string actuators(const Twin& twin) {
    std::string text = "  <actuator>\n";
    for (std::size_t i = 0; i < 2; ++i) text += motor(kNames[i], twin.sides[i].gear.torque_scale, twin.sides[i].gear.saturation);
    return text + motor("joint", 1.0, std::numeric_limits<double>::infinity()) + "  </actuator>\n";
}

std::string head(const Twin& twin) {
    std::string text = fmt::format(
        "<!-- {}\n"
        "     Angles, signs and torques: winding its own cable in is positive at a capstan; q stretches the agonist's K_SE. SI units, "
        "radians.\n"
        "     Without companion this model has each spring as a cubic (errors below), and the friction that gears and bearing have at "
        "{:.4g} "
        "Nm of\n"
        "     co-contraction. {} and {} apply the exact laws of {}. -->\n",
        comment(twin.source), twin.reference_torque, kJavaScriptFile, kPythonFile, kLawsFile);
    for (const std::string& sentence : twin.not_expressed) text += fmt::format("<!-- not in this model: {} -->\n", comment(sentence));
    return text;
}

}  // namespace

std::string model_xml(const Twin& twin) {
    const double step = time_step(twin);
    std::string text = head(twin);
    text += fmt::format("<mujoco model=\"{}\">\n", core::escape(twin.name));
    text += "  <compiler angle=\"radian\" autolimits=\"true\"/>\n";
    text +=
        fmt::format("  <option timestep=\"{}\" integrator=\"Euler\" solver=\"Newton\" iterations=\"100\" tolerance=\"1e-12\"/>\n", step);
    text += fmt::format("  <default>\n    <joint solreffriction=\"{} 1\" solimpfriction=\"{} {} 0.001 0.5 2\"/>\n", 2.0 * step, kHardest,
                        kHardest);
    text += "    <geom contype=\"0\" conaffinity=\"0\"/>\n  </default>\n  <worldbody>\n";
    text += fmt::format("    <light pos=\"0 0 {}\"/>\n", 20.0 * twin.capstan_radius);
    text += capstan(twin, 0) + capstan(twin, 1) + output(twin) + "  </worldbody>\n" + tendons(twin) + actuators(twin);
    text += "  <sensor>\n";
    for (const char* const name : {kNames[0], kNames[1], "joint"})
        text += fmt::format("    <jointpos name=\"angle_{0}\" joint=\"{0}\"/>\n", name);
    return text + "  </sensor>\n</mujoco>\n";
}

}  // namespace fusee::mjcf
