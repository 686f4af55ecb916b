#include <fmt/format.h>

#include <cmath>

#include "design/cam_figures.h"
#include "design/page.h"
#include "design/stretch.h"
#include "page/column.h"
#include "page/html.h"
#include "page/svg_plot.h"

namespace fusee::report {

namespace {

using core::deg_from_rad;

std::string range_text(const core::Range& r, const std::string& unit, int digits = 4) {
    return number(r.low, digits) + " to " + number(r.high, digits) + " " + unit;
}

std::string law_plots(const LawReport& law) {
    using P = spring::LawPoint;
    const auto of = [&law](const auto& get) { return column(law.samples, get); };
    const auto tau = of([](const P&p) { return p.tau; }), theta = of([](const P&p) { return p.theta; });
    const auto f_se = of([](const P&p) { return p.f_se; }), f_pe = of([](const P&p) { return p.f_pe; });
    const core::Range lead_in{law.samples.front().tau, law.design_loads.low}, lead_in_angle{0.0, law.lead_in_travel};
    const std::string angle = "capstan angle [rad]", load = "capstan load [Nm]";

    Plot over_angle("Spring torques over the capstan's angle", angle, "torque [Nm]");
    over_angle.shade(lead_in_angle, "lead-in").curve("F_SE", theta, f_se, "se").curve("F_PE", theta, f_pe, "pe");
    over_angle.curve("sum", theta, tau, "sum", true).from_zero();
    Plot over_load("Spring torques over the load", load, "torque [Nm]");
    over_load.shade(lead_in, "lead-in").mark(law.stiction_loads.low, "stiction, low").mark(law.stiction_loads.high, "stiction, high");
    over_load.curve("F_SE", tau, f_se, "se").curve("F_PE", tau, f_pe, "pe").from_zero();
    Plot stiffness("Stiffness", load, "stiffness [Nm/rad]");
    stiffness.shade(lead_in, "lead-in").curve("S", tau, of([](const P& p) { return p.s; }), "se");
    stiffness.curve("P", tau, of([](const P& p) { return p.p; }), "pe").from_zero();
    Plot share("T = S/(S+P): share of stiction that reaches the joint", load, "T [1]");
    share.shade(lead_in, "lead-in").curve("T", tau, of([](const P& p) { return p.transmission(); }), "t").from_zero();
    return over_angle.svg() + over_load.svg() + stiffness.svg() + share.svg();
}

std::string law_facts(const LawReport& law) {
    std::vector<std::pair<std::string, std::string>> facts{
        {"loads, lead-in included", range_text({law.samples.front().tau, law.samples.back().tau}, "Nm")},
        {"loads of the law itself", range_text(law.design_loads, "Nm")},
        {"capstan travel",
         fmt::format("{} rad ({} deg)", number(law.samples.back().theta), number(deg_from_rad(law.samples.back().theta)))},
        {"lead-in", law.lead_in_travel > 0.0 ? fmt::format("{} deg of capstan, {} to {} Nm", number(deg_from_rad(law.lead_in_travel)),
                                                           number(law.samples.front().tau), number(law.design_loads.low))
                                             : "none"},
        {"loads of stuck capstans", range_text(law.stiction_loads, "Nm") + (law.covers_stiction() ? ": covered" : ": not covered")}};
    if (law.least_feasible_start == law.least_feasible_start)
        facts.emplace_back("least feasible start", number(law.least_feasible_start) + " Nm");
    return "<div class=\"card wide\"><h3>The law</h3>" + html_facts(facts) + "</div>\n";
}

/// Bounds are rounded outwards: what is printed is proven too.
std::string certificate_text(const cam::Certificate& c) {
    const cam::LeastRadius& least = c.least();
    const std::string bound =
        std::isfinite(least.proven) ? fmt::format("\u2265 {:.4f} mm on all of the contour, ", std::floor(1e7 * least.proven) / 1e4) : "";
    return fmt::format("{}convex: {}, cable unrolls in order: {} ({} boxes){}", bound, to_string(c.convex), to_string(c.ordered), c.boxes,
                       c.open.empty() ? "" : "; " + c.open);
}

/// What runs on the part, and with what force.
std::pair<std::string, std::string> partner(const cam::Cam& cam, const CamFigures& f) {
    if (!cam.has_roller())
        return {"cable", fmt::format("{} mm, {}", number(core::mm_from_m(cam.options.cable_diameter)), range_text(f.tensions, "N", 3))};
    double steepest = 0.0;
    for (const cam::Contact& c : cam.working) steepest = std::max(steepest, std::abs(cam::pressure_angle(c.arm, cam.options.roller)));
    return {"roller", fmt::format("{} mm radius, {}, pressure angle up to {} deg", number(core::mm_from_m(cam.options.roller.radius)),
                                  range_text(f.tensions, "N", 3), number(deg_from_rad(steepest), 3))};
}

std::string cam_facts(const PartReport& report) {
    const solid::Part& part = *report.part;
    const CamFigures f = measure(part.cam);
    const solid::Box box = solid::bounding_box(part.mesh);
    const bool torsion = report.spring.kind == spring::BaseKind::kTorsion;
    const double scale = torsion ? 1.0 : 1e3;
    const core::Range states{f.states.low * scale, f.states.high * scale};
    const core::Range loads{f.states.low * report.spring.rate, f.states.high * report.spring.rate};
    std::vector<std::pair<std::string, std::string>> facts{
        {"path", part.cam.closed() ? "planar, closed" : "helix"},
        {"lever arm", range_text(f.arms_mm, "mm")},
        {"cam travel", fmt::format("{} deg", number(deg_from_rad(f.travel)))},
        {"working arc", fmt::format("{} turns", number(part.cam.working_psi.width() / (2.0 * core::kPi), 3))},
        {"least radius of curvature", number(f.least_rho_mm) + " mm"},
        {"by interval arithmetic", certificate_text(report.certificate)},
        partner(part.cam, f),
        {"base spring", fmt::format("{} {}", number(report.spring.rate), torsion ? "Nm/rad" : "N/m")},
        {torsion ? "spring winding" : "spring travel", range_text(states, torsion ? "rad" : "mm")},
        {torsion ? "spring torque" : "spring force", range_text(loads, torsion ? "Nm" : "N")},
        {"box", fmt::format("{} x {} x {} mm", number(box.high_mm[0] - box.low_mm[0]), number(box.high_mm[1] - box.low_mm[1]),
                            number(box.high_mm[2] - box.low_mm[2]))},
        {"volume", fmt::format("{} mm\u00b3", number(solid::volume_mm3(part.mesh)))},
        {"mesh", fmt::format("{} triangles, within {} mm", part.mesh.triangles.size(), number(part.chordal_error_mm))},
        {"smallest angle, shortest edge",
         fmt::format("{} deg, {} mm", number(report.quality.smallest_angle_deg, 2), number(report.quality.shortest_edge_mm, 2))}};
    if (const cam::ArmPoint& most = part.cam.working.back().arm; most.stretch.turn != 0.0)
        facts.emplace_back("cable's stretch, cut for", stretch_text(most));
    return "<div class=\"card\">" + html_facts(facts) + "</div>\n";
}

}  // namespace

std::string law_section(const DesignReport& design) {
    if (design.law.samples.empty()) return "";
    return "<section><h2>Spring law</h2><div class=\"grid\">" + law_plots(design.law) + law_facts(design.law) + "</div></section>\n";
}

std::string dead_band_section(const DesignReport& design) {
    if (design.dead_band.empty()) return "";
    using D = actuator::DeadBand;
    const auto tau = column(design.dead_band, [](const D& d) { return d.tau; });
    Plot band("Dead-band at the joint, edge to edge", "co-contraction, motor torque at the capstan [Nm]", "dead-band [deg]");
    band.curve("linear: 2 mu tau / (g P)", tau, column(design.dead_band, [](const D& d) { return deg_from_rad(d.linear); }), "linear",
               true);
    band.curve("exact extremes", tau, column(design.dead_band, [](const D& d) { return deg_from_rad(d.exact_width); }), "exact")
        .from_zero();
    Plot stiffness("Stiffness of the joint", "co-contraction, motor torque at the capstan [Nm]", "stiffness [Nm/rad]");
    stiffness.curve("capstans held", tau, column(design.dead_band, [](const D& d) { return d.joint_stiffness; }), "se");
    stiffness.curve("capstans free", tau, column(design.dead_band, [](const D& d) { return d.free_joint_stiffness; }), "sum", true);
    return "<section><h2>What stiction leaves at the joint</h2><div class=\"grid\">" + band.svg() + stiffness.from_zero().svg() +
           "</div></section>\n";
}

std::string part_section(const PartReport& report, const std::vector<Marker>& markers) {
    const cam::Cam& cam = report.part->cam;
    const bool series = cam.kind == cam::PartKind::kSeries;
    const auto angle = column(cam.working, [](const cam::Contact& c) { return deg_from_rad(c.arm.angle); });
    Plot arm("Lever arm", "cam angle [deg]", "arm [mm]");
    arm.curve("arm", angle, column(cam.working, [](const cam::Contact& c) { return core::mm_from_m(c.arm.arm); }), series ? "se" : "pe");
    Plot height("Height of the cable on the helix", "cam angle [deg]", "z [mm]");
    height.curve("z", angle, column(cam.working, [](const cam::Contact& c) { return core::mm_from_m(c.path.z); }), "sum");
    return fmt::format("<section><h2>{}: {}</h2><div class=\"part\"><figure class=\"card\">", cam::to_string(cam.kind),
                       series ? "spool of the series spring" : "cam of the parallel spring") +
           cam_svg(*report.part, markers) +
           "<p class=\"faint\">Seen from +z at cam angle 0, to scale. Filled: the part just under its top face; coloured: the " +
           (cam.has_roller() ? "working arc of the rim; round: the roller at the lowest and (dashed) at the highest load; "
                             : "cable's centreline on the working arc; thin: groove floor; straight: the cable at the lowest and (dashed) "
                               "at the highest load; ") +
           "numbers: findings.</p></figure><div class=\"stack\">" + cam_facts(report) + arm.svg() + (cam.closed() ? "" : height.svg()) +
           "</div></div></section>\n";
}

}  // namespace fusee::report
