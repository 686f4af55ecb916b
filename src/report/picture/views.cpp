#include <fmt/format.h>

#include <array>
#include <optional>

#include "data/figures.h"
#include "fusee/core/error.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"
#include "fusee/drawing/picture.h"
#include "fusee/report/assembly.h"
#include "fusee/report/picture.h"
#include "fusee/report/report.h"
#include "page/column.h"
#include "picture/plot.h"
#include "picture/standalone.h"
#include "rig/gap_map.h"

/// The charts of `fusee render`; each needs what it shows. The pages draw theirs in the browser (web/src/pages/design).
namespace fusee::report {

namespace {

constexpr const char* kCapstanLoad = "capstan load [Nm]";

core::Range lead_in(const LawReport& law) { return {law.samples.front().tau, law.design_loads.low}; }

std::vector<double> cam_angles(const cam::Cam& cam) {
    return column(cam.working, [](const cam::Contact& c) { return deg_from_rad(c.arm.angle); });
}

Plot law_chart(const LawReport& law) {
    const std::vector<double> theta = column(law.samples, &spring::LawPoint::theta);
    return Plot("Spring torques over the capstan's angle", "capstan angle [rad]", "torque [Nm]")
        .shade({0.0, law.lead_in_travel}, "lead-in")
        .curve("F_SE", theta, column(law.samples, &spring::LawPoint::f_se), "se")
        .curve("F_PE", theta, column(law.samples, &spring::LawPoint::f_pe), "pe")
        .curve("sum", theta, column(law.samples, &spring::LawPoint::tau), "sum", true)
        .from_zero();
}

Plot stiffness_chart(const LawReport& law) {
    const std::vector<double> tau = column(law.samples, &spring::LawPoint::tau);
    return Plot("Stiffness", kCapstanLoad, "stiffness [Nm/rad]")
        .shade(lead_in(law), "lead-in")
        .curve("S", tau, column(law.samples, &spring::LawPoint::s), "se")
        .curve("P", tau, column(law.samples, &spring::LawPoint::p), "pe")
        .from_zero();
}

Plot transmission_chart(const LawReport& law) {
    return Plot("T = S/(S+P): share of stiction that reaches the joint", kCapstanLoad, "T [1]")
        .shade(lead_in(law), "lead-in")
        .curve("T", column(law.samples, &spring::LawPoint::tau), column(law.samples, &spring::LawPoint::transmission), "t")
        .from_zero();
}

Plot dead_band_chart(const std::vector<actuator::DeadBand>& levels) {
    const std::vector<double> tau = column(levels, &actuator::DeadBand::tau);
    return Plot("Dead-band at the joint, edge to edge", kCoContractionAxis, "dead-band [deg]")
        .curve("linear: 2 mu tau / (g P)", tau, column(levels, [](const actuator::DeadBand& d) { return deg_from_rad(d.linear); }),
               "linear", true)
        .curve("exact", tau, column(levels, [](const actuator::DeadBand& d) { return deg_from_rad(d.exact_width); }), "exact")
        .from_zero();
}

Plot joint_stiffness_chart(const std::vector<actuator::DeadBand>& levels) {
    const std::vector<double> tau = column(levels, &actuator::DeadBand::tau);
    return Plot("Stiffness of the joint", kCoContractionAxis, "stiffness [Nm/rad]")
        .curve("capstans held", tau, column(levels, &actuator::DeadBand::joint_stiffness), "se")
        .curve("capstans free", tau, column(levels, &actuator::DeadBand::free_joint_stiffness), "sum", true)
        .from_zero();
}

Plot arm_chart(const cam::Cam& cam) {
    return Plot("Lever arm", "cam angle [deg]", "arm [mm]")
        .curve("arm", cam_angles(cam), column(cam.working, [](const cam::Contact& c) { return core::mm_from_m(c.arm.arm); }),
               cam.kind == cam::PartKind::kSeries ? "se" : "pe");
}

Plot height_chart(const cam::Cam& cam) {
    return Plot("Height of the cable on the helix", "cam angle [deg]", "z [mm]")
        .curve("z", cam_angles(cam), column(cam.working, [](const cam::Contact& c) { return core::mm_from_m(c.path.z); }), "sum");
}

using pipeline::DesignReport;

/// A view that is a chart; none if the design lacks what it shows.
struct ChartView {
    const char *name, *meaning;
    std::optional<Plot> (*chart)(const DesignReport&);
};

template <Plot (*of)(const LawReport&)>
std::optional<Plot> of_law(const DesignReport& design) {
    return design.law.samples.empty() ? std::nullopt : std::optional(of(design.law));
}
template <Plot (*of)(const std::vector<actuator::DeadBand>&)>
std::optional<Plot> of_levels(const DesignReport& design) {
    return design.dead_band.empty() ? std::nullopt : std::optional(of(design.dead_band));
}
template <cam::PartKind kind, Plot (*of)(const cam::Cam&)>
std::optional<Plot> of_cam(const DesignReport& design) {
    for (const PartReport& part : design.parts)
        if (const cam::Cam& cam = part.part->cam; cam.kind == kind && (of != height_chart || !cam.closed())) return of(cam);
    return std::nullopt;
}

constexpr std::array<ChartView, 8> kCharts{{
    {"law", "torques of both springs over the capstan's angle", of_law<law_chart>},
    {"stiffness", "stiffness of both springs over the load", of_law<stiffness_chart>},
    {"transmission", "share of the stiction that reaches the joint", of_law<transmission_chart>},
    {"dead-band", "dead-band over the co-contraction", of_levels<dead_band_chart>},
    {"joint-stiffness", "stiffness of the joint over the co-contraction", of_levels<joint_stiffness_chart>},
    {"k_se-arm", "lever arm of K_SE over its angle", of_cam<cam::PartKind::kSeries, arm_chart>},
    {"k_pe-arm", "lever arm of K_PE over its angle", of_cam<cam::PartKind::kParallel, arm_chart>},
    {"k_pe-height", "height of the cable on a helical K_PE", of_cam<cam::PartKind::kParallel, height_chart>},
}};

[[noreturn]] void refuse_view(const std::string& view, const std::string& allowed) { throw core::InvalidInput("--view", view, allowed); }

std::string chart(const DesignReport& design, const ChartView& view, Theme theme) {
    const std::optional<Plot> plot = view.chart(design);
    if (!plot) refuse_view(view.name, "another view: this design does not have it");
    return standalone({plot->figure()}, theme);
}

/// A shaded picture as an SVG in millimetres.
std::string shaded_view(const std::vector<drawing::Object>& objects, int longest_px) {
    const drawing::Picture picture =
        drawing::draw(objects, drawing::from_direction(core::rad_from_deg(-55.0), core::rad_from_deg(32.0)), longest_px);
    const Eigen::Vector2d size = picture.high_mm - picture.low_mm;
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}mm\" height=\"{1}mm\">"
        "<image width=\"{0}\" height=\"{1}\" href=\"{2}\"/></svg>\n",
        core::coordinate(size.x()), core::coordinate(size.y()), drawing::data_uri(drawing::png(picture)));
}

/// All cams of the design, side by side, as they lie in their own frames.
std::string cams(const DesignReport& design, int longest_px) {
    constexpr double kApart_mm = 8.0;
    constexpr std::array<drawing::Colour, 2> kColours{{{63, 127, 208}, {208, 96, 63}}};  // as in assembly::colour_of
    std::vector<drawing::Object> objects;
    double right = 0.0;
    for (const PartReport& part : design.parts) {
        const solid::Box box = solid::bounding_box(part.part->mesh);
        const double shift = right - box.low_mm[0];
        drawing::Object object{part.part->mesh, kColours.at(part.part->cam.kind == cam::PartKind::kSeries ? 0 : 1)};
        for (solid::Vec3& p : object.mesh.points_mm) p[0] += shift, p[2] -= box.low_mm[2];
        right = shift + box.high_mm[0] + kApart_mm;
        objects.push_back(std::move(object));
    }
    return shaded_view(objects, longest_px);
}

const assembly::Assembly& assembly_for(const DesignReport& design, const std::string& view) {
    if (!design.assembly)
        refuse_view(view, "cams or a chart: this profile has no assembly: it is a single spring, or its findings say why");
    return *design.assembly;
}

std::string joint(const DesignReport& design, const std::string& view, const PictureOptions& options) {
    const assembly::Assembly& a = assembly_for(design, view);
    return view == "assembly" ? assembly_view(a, options.pose, options.longest_px) : assembly_exploded(a, options.longest_px);
}

}  // namespace

const std::vector<PictureView>& design_views() {
    static const std::vector<PictureView> kViews = [] {
        std::vector<PictureView> views{{"cams", "both cams, shaded"},
                                       {"assembly", "the joint put together, shaded"},
                                       {"exploded", "the joint taken apart, with the names of its bodies"},
                                       {kMotionView, "the joint in motion through one co-contraction, an animated PNG"}};
        for (const ChartView& chart : kCharts) views.push_back({chart.name, chart.meaning});
        return views;
    }();
    return kViews;
}

std::string motion_picture(const DesignReport& design, int longest_px) {
    return assembly_motion(assembly_for(design, kMotionView), longest_px);
}

std::string design_picture(const DesignReport& design, const std::string& view, const PictureOptions& options) {
    if (view == "cams") return cams(design, options.longest_px);
    if (view == "assembly" || view == "exploded") return joint(design, view, options);
    const ChartView* found = core::find_by(kCharts, &ChartView::name, view);
    if (found == nullptr) refuse_view(view, core::listed(design_views(), &PictureView::name));
    return chart(design, *found, options.theme);
}

}  // namespace fusee::report
