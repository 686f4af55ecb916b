#include "picture/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "data/figures.h"

namespace fusee::report {

namespace {

// Drawing units; the page scales the whole picture.
constexpr double kWidth = 520, kHeight = 300, kLeft = 58, kRight = 14, kLegend = 16, kLegendRow = 18, kBare = 12, kBottom = 46, kTick = 5;
constexpr int kTicks = 5;
constexpr double kNoteHeight = 14;
constexpr double kLetter = 6.6, kLegendGap = 40;
constexpr double kTickGap = 8, kNameWidth = 22;  // between tick labels and axis; width of the axis name

double key_width(const std::string& label) { return kLegendGap + kLetter * static_cast<double>(label.size()); }

/// Range of the finite values; {0, 1} without any, widened if all are equal.
core::Range range_of(const std::vector<const std::vector<double>*>& columns) {
    core::Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const std::vector<double>* column : columns)
        for (const double value : *column) {
            if (!std::isfinite(value)) continue;
            range = {std::min(range.low, value), std::max(range.high, value)};
        }
    if (range.low > range.high) return {0.0, 1.0};
    const double least = 1e-9 * std::max(1.0, std::abs(range.high));
    return range.width() > least ? range : core::Range{range.low - 0.5, range.high + 0.5};
}

double round_step(double width, int count) {
    const double raw = width / count, power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (raw <= factor * power * 1.0001) return factor * power;
    return 10.0 * power;
}

/// Ticks without the noise of repeated addition: 0.30000000000000004 is shown as 0.3.
std::string tick_text(double value) { return fmt::format("{:g}", value); }

constexpr std::size_t kFirstDark = 6;  // white figures have more contrast from here on
constexpr double kBaseline = 4.0;      // from the middle of a line of text to its foot
constexpr double kKey = 76, kKeyHeight = 22;

}  // namespace

std::vector<double> round_ticks(const core::Range& range, int count) {
    const double step = round_step(range.width(), count);
    std::vector<double> ticks;
    for (double i = std::ceil(range.low / step - 1e-9); i <= range.high / step + 1e-9; ++i) ticks.push_back(i == 0.0 ? 0.0 : i * step);
    return ticks;
}

/// Leads from values to drawing units.
struct Plot::Frame {
    core::Range x, y;
    double top = kBare, left = kLeft;
    [[nodiscard]] double at_x(double value) const { return left + (value - x.low) / x.width() * (kWidth - left - kRight); }
    [[nodiscard]] double at_y(double value) const { return kHeight - kBottom - (value - y.low) / y.width() * (kHeight - top - kBottom); }
};

Plot::Plot(std::string title, std::string x_name, std::string y_name)
    : title_(std::move(title)), x_name_(std::move(x_name)), y_name_(std::move(y_name)) {}

Plot& Plot::curve(std::string label, std::vector<double> x, std::vector<double> y, std::string css, bool dashed) {
    curves_.push_back({std::move(label), std::move(x), std::move(y), std::move(css), dashed});
    return *this;
}
Plot& Plot::shade(const core::Range& x, std::string label) {
    if (x.width() > 0.0) shades_.emplace_back(x, std::move(label));
    return *this;
}
Plot& Plot::from_zero() {
    from_zero_ = true;
    return *this;
}

Plot::Frame Plot::frame() const {
    std::vector<const std::vector<double>*> xs, ys;
    for (const Curve& curve : curves_) {
        xs.push_back(&curve.x);
        ys.push_back(&curve.y);
    }
    const std::size_t keys = legend_rows().size();
    Frame f{range_of(xs), range_of(ys), keys > 0 ? kLegend + kLegendRow * static_cast<double>(keys) : kBare};
    if (from_zero_) f.y = {std::min(0.0, f.y.low), std::max(0.0, f.y.high)};
    const double step = round_step(f.y.width(), kTicks);
    f.y = {std::floor(f.y.low / step + 1e-9) * step, std::ceil(f.y.high / step - 1e-9) * step};
    for (const double tick : round_ticks(f.y, kTicks))  // kLeft fits four letters
        f.left = std::max(f.left, kNameWidth + kLetter * static_cast<double>(tick_text(tick).size()) + kTickGap);
    return f;
}

std::string Plot::axes(const Frame& f) const {
    const double bottom = kHeight - kBottom;
    std::string out;
    for (const double tick : round_ticks(f.y, kTicks))
        out += fmt::format("<path class=\"rule\" d=\"M{} {}H{}\"/><text class=\"tick\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>",
                           coordinate(f.left), coordinate(f.at_y(tick)), kWidth - kRight, coordinate(f.left - kTickGap),
                           coordinate(f.at_y(tick) + 4), tick_text(tick));
    for (const double tick : round_ticks(f.x, kTicks + 1))
        out += fmt::format("<path class=\"axis\" d=\"M{} {}v{}\"/><text class=\"tick\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                           coordinate(f.at_x(tick)), bottom, kTick, coordinate(f.at_x(tick)), bottom + 19, tick_text(tick));
    out += fmt::format("<path class=\"axis\" d=\"M{} {}H{}\"/>", coordinate(f.left), bottom, kWidth - kRight);
    out += fmt::format("<text class=\"name\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                       coordinate((f.left + kWidth - kRight) / 2), kHeight - 8, escape(x_name_));
    out += fmt::format("<text class=\"name\" transform=\"translate(15 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
                       (f.top + bottom) / 2, escape(y_name_));
    return out;
}

std::string Plot::curves(const Frame& f) const {
    std::string out;
    for (const Curve& curve : curves_) {
        std::string path;
        bool down = false;
        for (std::size_t i = 0; i < curve.x.size(); ++i) {
            const bool shown = std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]);
            if (shown) path += (down ? "L" : "M") + coordinate(f.at_x(curve.x[i])) + " " + coordinate(f.at_y(curve.y[i]));
            down = shown;
        }
        out += fmt::format("<path class=\"curve {}{}\" d=\"{}\"><title>{}</title></path>", curve.css, curve.dashed ? " dashed" : "", path,
                           escape(curve.label));
    }
    return out;
}

std::string Plot::notes(const Frame& f) const {
    std::string out;
    for (const auto& [range, label] : shades_) {
        const double left = f.at_x(std::max(range.low, f.x.low)), right = f.at_x(std::min(range.high, f.x.high));
        out += fmt::format("<rect class=\"shade\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"><title>{}</title></rect>", coordinate(left),
                           f.top, coordinate(std::max(0.0, right - left)), kHeight - f.top - kBottom, escape(label));
        if (right - left < kNoteHeight) continue;  // the name would cover the curves; the tooltip still shows it
        out += fmt::format("<text class=\"note\" transform=\"translate({} {}) rotate(-90)\" text-anchor=\"end\">{}</text>",
                           coordinate((left + right) / 2 + 4), f.top + 5, escape(label));
    }
    return out;
}

/// Keys of the legend in lines that fit the width; none for a single curve.
std::vector<std::vector<Plot::Key>> Plot::legend_rows() const {
    std::vector<std::vector<Key>> rows;
    if (curves_.size() < 2) return rows;
    double x = kWidth;
    const auto add = [&](std::string mark, const std::string& label) {
        if (rows.empty() || x + key_width(label) > kWidth) {
            rows.emplace_back();
            x = kLeft;
        }
        rows.back().push_back({std::move(mark), label});
        x += key_width(label);
    };
    for (const Curve& curve : curves_)
        add(fmt::format("<path class=\"curve {}{}\" d=\"M0 0h20\"/>", curve.css, curve.dashed ? " dashed" : ""), curve.label);
    return rows;
}

std::string Plot::legend() const {
    std::string out;
    double y = 20;
    for (const std::vector<Key>& row : legend_rows()) {
        double x = kLeft;
        for (const Key& key : row) {
            out += fmt::format("<g transform=\"translate({} {})\">{}<text class=\"key\" x=\"26\" y=\"4\">{}</text></g>", coordinate(x), y,
                               key.mark, escape(key.label));
            x += key_width(key.label);
        }
        y += kLegendRow;
    }
    return out;
}

Figure Plot::figure() const {
    const Frame f = frame();
    return {title_, kWidth, kHeight, axes(f) + notes(f) + curves(f) + legend()};
}

std::string heat_cell(const Box& box, double gap, const std::string& text) {
    const bool empty = !std::isfinite(gap);
    const auto level =
        empty ? 0 : static_cast<std::size_t>(std::upper_bound(kGapBounds.begin(), kGapBounds.end(), gap) - kGapBounds.begin());
    const std::string ink = empty ? "" : fmt::format(" style=\"fill:{}\"", level < kFirstDark ? "#15151a" : "#ffffff");
    return fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"#8b8a85\" stroke-width=\".5\"/>"
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\"{}>{}</text>",
        coordinate(box.x), coordinate(box.y), coordinate(box.width), coordinate(box.height), empty ? "none" : kGapFills[level],
        coordinate(box.x + box.width / 2), coordinate(box.y + box.height / 2 + kBaseline), ink, escape(empty ? number(gap) : text));
}

Figure gap_legend() {
    Figure legend{"gap [sigma]", kKey * kGapFills.size(), kKeyHeight + 2, ""};
    for (std::size_t i = 0; i < kGapFills.size(); ++i) {
        const double low = i == 0 ? 0.0 : kGapBounds[i - 1];
        const std::string text = i == 0                      ? fmt::format("below {}", kGapBounds[0])
                                 : i + 1 == kGapFills.size() ? fmt::format("{} or more", low)
                                                             : fmt::format("{} to {}", low, kGapBounds[i]);
        legend.content += heat_cell({kKey * static_cast<double>(i), 1, kKey, kKeyHeight}, low, text);
    }
    return legend;
}

}  // namespace fusee::report
