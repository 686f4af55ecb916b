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
    const double travel = law.samples.back().theta;
    const core::Range loads{law.samples.front().tau, law.samples.back().tau};
    const core::Range lead_in{law.samples.front().tau, law.design_loads.low};
    Facts facts{
        {"loads, lead-in included", span(loads, 4) + " Nm"},
        {"loads of the law", span(law.design_loads, 4) + " Nm"},
        {"capstan travel", fmt::format("{} rad ({} deg)", number(travel), deg(travel))},
        {"lead-in", law.lead_in_travel > 0.0 ? fmt::format("{} deg of capstan, {} Nm", deg(law.lead_in_travel), span(lead_in, 4)) : "none"},
        {"loads of stuck capstans", span(law.stiction_loads, 4) + (law.covers_stiction() ? " Nm: covered" : " Nm: not covered")}};
    if (std::isfinite(law.least_feasible_start)) facts.emplace_back("least feasible start", newton_metres(law.least_feasible_start, 4));
    return "<div class=\"card wide\"><h3>The law</h3>" + html_facts(facts) + "</div>\n";
}

/// Bounds are rounded outwards, so that the printed value is proven too.
std::string certificate_text(const cam::Certificate& c) {
    const cam::LeastRadius& least = c.least();
    const std::string bound =
        std::isfinite(least.proven) ? fmt::format("\u2265 {:.4f} mm on the whole contour, ", std::floor(1e7 * least.proven) / 1e4) : "";
    return fmt::format("{}convex: {}, cable unrolls in order: {} ({} boxes){}", bound, to_string(c.convex), to_string(c.ordered), c.boxes,
                       c.open.empty() ? "" : "; " + c.open);
}

/// The cable or roller on the part, and its force.
Facts::value_type partner(const cam::Cam& cam, const CamFigures& f) {
    const std::string forces = span(f.tensions) + " N";
    if (!cam.has_roller()) return {"cable", fmt::format("{} mm, {}", number(core::mm_from_m(cam.options.cable_diameter)), forces)};
    double steepest = 0.0;
    for (const cam::Contact& c : cam.working) steepest = std::max(steepest, std::abs(cam::pressure_angle(c.arm, cam.options.roller)));
    return {"roller", fmt::format("{} mm radius, {}, pressure angle up to {} deg", number(core::mm_from_m(cam.options.roller.radius)),
                                  forces, deg(steepest, 3))};
}

std::string cam_facts(const PartReport& report) {
    const solid::Part& part = *report.part;
    const CamFigures f = measure(part.cam);
    const solid::Box box = solid::bounding_box(part.mesh);
    const bool torsion = report.spring.kind == spring::BaseKind::kTorsion;
    const double scale = torsion ? 1.0 : 1e3;
    const core::Range states{f.states.low * scale, f.states.high * scale};
    const core::Range loads{f.states.low * report.spring.rate, f.states.high * report.spring.rate};
    Facts facts{{"path", part.cam.closed() ? "planar, closed" : "helix"},
                {"lever arm", span(f.arms_mm, 4) + " mm"},
                {"cam travel", deg(f.travel) + " deg"},
                {"working arc", fmt::format("{} turns", number(part.cam.working_psi.width() / (2.0 * core::kPi), 3))},
                {"least radius of curvature", number(f.least_rho_mm) + " mm"},
                {"by interval arithmetic", certificate_text(report.certificate)},
                partner(part.cam, f),
                {"base spring", fmt::format("{} {}", number(report.spring.rate), torsion ? "Nm/rad" : "N/m")},
                {torsion ? "spring winding" : "spring travel", span(states, 4) + (torsion ? " rad" : " mm")},
                {torsion ? "spring torque" : "spring force", span(loads, 4) + (torsion ? " Nm" : " N")},
                {"box", fmt::format("{} x {} x {} mm", number(box.high_mm[0] - box.low_mm[0]), number(box.high_mm[1] - box.low_mm[1]),
                                    number(box.high_mm[2] - box.low_mm[2]))},
                {"volume", fmt::format("{} mm\u00b3", number(solid::volume_mm3(part.mesh)))},
                {"mesh", fmt::format("{} triangles, within {} mm", part.mesh.triangles.size(), number(part.chordal_error_mm))},
                {"smallest angle, shortest edge",
                 fmt::format("{} deg, {} mm", number(report.quality.smallest_angle_deg, 2), number(report.quality.shortest_edge_mm, 2))}};
    if (const cam::ArmPoint& most = part.cam.working.back().arm; most.elongation.turn != 0.0)
        facts.emplace_back("cable elongation, compensated", stretch_text(most));
    return card(html_facts(facts));
}

}  // namespace

std::string law_section(const DesignReport& design) {
    return design.law.samples.empty() ? "" : section("Spring law", grid(law_plots(design.law) + law_facts(design.law)));
}

std::string dead_band_section(const DesignReport& design) {
    if (design.dead_band.empty()) return "";
    using D = actuator::DeadBand;
    const auto tau = column(design.dead_band, &D::tau);
    Plot band("Dead-band at the joint, edge to edge", kCoContractionAxis, "dead-band [deg]");
    band.curve("linear: 2 mu tau / (g P)", tau, column(design.dead_band, [](const D& d) { return deg_from_rad(d.linear); }), "linear",
               true);
    band.curve("exact", tau, column(design.dead_band, [](const D& d) { return deg_from_rad(d.exact_width); }), "exact").from_zero();
    Plot stiffness("Stiffness of the joint", kCoContractionAxis, "stiffness [Nm/rad]");
    stiffness.curve("capstans held", tau, column(design.dead_band, &D::joint_stiffness), "se");
    stiffness.curve("capstans free", tau, column(design.dead_band, &D::free_joint_stiffness), "sum", true);
    return section("Dead-band and stiffness of the joint", grid(band.svg() + stiffness.from_zero().svg()));
}

std::string part_section(const PartReport& report, const std::vector<Marker>& markers) {
    const cam::Cam& cam = report.part->cam;
    const bool series = cam.kind == cam::PartKind::kSeries;
    const auto angle = column(cam.working, [](const cam::Contact& c) { return deg_from_rad(c.arm.angle); });
    Plot arm("Lever arm", "cam angle [deg]", "arm [mm]");
    arm.curve("arm", angle, column(cam.working, [](const cam::Contact& c) { return core::mm_from_m(c.arm.arm); }), series ? "se" : "pe");
    Plot height("Height of the cable on the helix", "cam angle [deg]", "z [mm]");
    height.curve("z", angle, column(cam.working, [](const cam::Contact& c) { return core::mm_from_m(c.path.z); }), "sum");
    const std::string legend =
        cam.has_roller() ? "coloured: working arc of the rim; circles: roller at the lowest and (dashed) highest load"
                         : "coloured: cable centreline on the working arc; thin: groove floor; straight: cable at the lowest and (dashed) "
                           "highest load";
    return section(fmt::format("{}: {}", cam::to_string(cam.kind), series ? "spool of the series spring" : "cam of the parallel spring"),
                   "<div class=\"part\"><figure class=\"card\">" + cam_svg(*report.part, markers) +
                       faint_paragraph("View from +z at cam angle 0, to scale. Filled: section just below the top face; " + legend +
                                       "; numbers: findings; dots: places of rules that passed.") +
                       "</figure><div class=\"stack\">" + arm.svg() + (cam.closed() ? "" : height.svg()) + cam_facts(report) +
                       "</div></div>",
                   cam::to_string(cam.kind));
}

}  // namespace fusee::report
