#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "data/figures.h"
#include "diagnosis/words.h"
#include "fusee/core/error.h"
#include "fusee/report/diagnosis.h"
#include "fusee/report/picture.h"
#include "picture/plot.h"
#include "rig/gap_map.h"
#include "scene/scene.h"

namespace fusee::report {

namespace {

using diagnosis::GapCell;

// Drawing units, 520 wide like the charts of the page.
constexpr double kMapWidth = 520, kLeastLeft = 110, kMostLeft = 240, kMapRight = 24, kStrip = 30, kRow = 56, kTop = 6;
constexpr double kLabelDrop = 14, kRangeLetter = 6.0, kTitleLetter = 6.6, kNameGap = 20;
constexpr std::size_t kMostCells = 8;  // of a strip: narrower cells are too small for their figures

/// The cells of one experiment over one variable, by rising range.
struct Strip {
    std::string experiment, variable;
    std::vector<GapCell> cells;
    double left = kLeastLeft;  ///< where the cells begin, equal for all strips
    [[nodiscard]] double width() const { return (kMapWidth - left - kMapRight) / static_cast<double>(cells.size()); }
};

/// Splits strips of more than kMostCells.
std::vector<Strip> in_rows(const std::vector<Strip>& strips) {
    std::vector<Strip> out;
    for (const Strip& strip : strips)
        for (std::size_t i = 0; i < strip.cells.size(); ++i) {
            if (i % kMostCells == 0) out.push_back({strip.experiment, strip.variable, {}, strip.left});
            out.back().cells.push_back(strip.cells[i]);
        }
    return out;
}

std::vector<Strip> strips_of(const std::vector<GapCell>& map) {
    std::vector<Strip> strips;
    for (const GapCell& cell : map) {
        const auto same = [&](const Strip& s) { return s.experiment == cell.experiment && s.variable == cell.variable; };
        auto at = std::find_if(strips.begin(), strips.end(), same);
        if (at == strips.end()) at = strips.insert(at, {cell.experiment, cell.variable, {}, kLeastLeft});
        at->cells.push_back(cell);
    }
    double left = kLeastLeft;
    for (Strip& strip : strips) {
        const std::size_t letters = std::max(experiment_name(strip.experiment).size(), column_name(strip.variable).size());
        left = std::clamp(kTitleLetter * static_cast<double>(letters) + kNameGap, left, kMostLeft);
        std::stable_sort(strip.cells.begin(), strip.cells.end(),
                         [](const GapCell& a, const GapCell& b) { return a.region.low < b.region.low; });
    }
    for (Strip& strip : strips) strip.left = left;
    return in_rows(strips);
}

/// True if the ranges follow each other without a gap: their edges are labelled, else each range.
bool is_contiguous(const Strip& strip) {
    for (std::size_t i = 1; i < strip.cells.size(); ++i) {
        const core::Range &last = strip.cells[i - 1].region, &next = strip.cells[i].region;
        if (!(std::abs(next.low - last.high) <= 1e-6 * (next.high - last.low))) return false;
    }
    return true;
}

std::string range_label(double x, double y, const std::string& text) {
    return fmt::format("<text class=\"note\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>", coordinate(x), coordinate(y),
                       escape(text));
}

/// Labels below a strip, as many as fit.
std::string range_labels(const Strip& strip, double top) {
    const double width = strip.width(), y = top + kStrip + kLabelDrop;
    std::string out;
    double free_from = 0.0;
    const auto add = [&](double x, const std::string& text) {
        const double half = kRangeLetter * static_cast<double>(text.size()) / 2;
        if (x - half < free_from) return;
        out += range_label(x, y, text);
        free_from = x + half;
    };
    const bool edges = is_contiguous(strip);
    for (std::size_t i = 0; i < strip.cells.size(); ++i) {
        const core::Range& region = strip.cells[i].region;
        const double left = strip.left + width * static_cast<double>(i);
        if (edges)
            add(left, number(region.low, 3));
        else
            add(left + width / 2, region.width() > 0.0 ? number(region.low, 2) + "\u2013" + number(region.high, 2) : number(region.low, 3));
    }
    if (edges) add(kMapWidth - kMapRight, number(strip.cells.back().region.high, 3));
    return out;
}

std::string strip_svg(const Strip& strip, double top, double GapCell::*gap) {
    std::string out =
        fmt::format("<text class=\"name\" x=\"0\" y=\"{}\">{}</text><text class=\"note\" x=\"0\" y=\"{}\">{}</text>", coordinate(top + 13),
                    escape(experiment_name(strip.experiment)), coordinate(top + 28), escape(column_name(strip.variable)));
    const double width = strip.width();
    for (std::size_t i = 0; i < strip.cells.size(); ++i) {
        const double value = strip.cells[i].*gap;
        out += heat_cell({strip.left + width * static_cast<double>(i), top, width, kStrip}, value, number(value, 2));
    }
    return out + range_labels(strip, top);
}

Figure map_figure(const std::vector<Strip>& strips, const std::string& title, double GapCell::*gap) {
    Figure figure{title, kMapWidth, kTop + kRow * static_cast<double>(strips.size()), ""};
    double top = kTop;
    for (const Strip& strip : strips) {
        figure.content += strip_svg(strip, top, gap);
        top += kRow;
    }
    return figure;
}

}  // namespace

std::vector<Figure> gap_map_figures(const std::vector<diagnosis::GapCell>& map) {
    if (map.empty()) return {};
    const std::vector<Strip> strips = strips_of(map);
    return {map_figure(strips, "Before: the nominal model", &GapCell::before),
            map_figure(strips, "After: with the effects found", &GapCell::after), gap_legend()};
}

std::string gap_map_picture(const diagnosis::Diagnosis& diagnosis, Theme theme) {
    const std::vector<Figure> figures = gap_map_figures(diagnosis.map);
    if (figures.empty()) throw core::InvalidInput("--view", kGapMapView, "a case with measured rows: the diagnosis of this one has no map");
    return standalone(figures, theme);
}

JointScene joint_scene(const pipeline::DesignReport& joint) { return {joint_plan_json(joint), scene_json(joint)}; }

}  // namespace fusee::report
