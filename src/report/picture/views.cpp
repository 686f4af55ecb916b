#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "fusee/core/error.h"
#include "fusee/core/text.h"
#include "fusee/drawing/picture.h"
#include "fusee/report/assembly.h"
#include "fusee/report/picture.h"
#include "picture/charts.h"
#include "picture/standalone.h"
#include "rig/gap_map.h"

namespace fusee::report {

namespace {

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
    const auto found = std::find_if(kCharts.begin(), kCharts.end(), [&](const ChartView& chart) { return view == chart.name; });
    if (found == kCharts.end()) {
        std::vector<std::string> names;
        for (const PictureView& one : design_views()) names.push_back(one.name);
        refuse_view(view, fmt::format("{}", fmt::join(names, ", ")));
    }
    return chart(design, *found, options.theme);
}

}  // namespace fusee::report
