#include "fusee/drawing/sheet.h"

#include <algorithm>

#include "fusee/core/text.h"

namespace fusee::drawing {

namespace {

constexpr double kLetter = 0.602;                  // of the size: DejaVu Sans Mono; Courier and Liberation Mono 0.600
constexpr double kAscent = 0.76, kDescent = 0.24;  // of the size

/// Narrows [from, to], the share of a line within low..high in one coordinate. False: nothing remains.
bool clip(double start, double step, double low, double high, double& from, double& to) {
    if (step == 0.0) return start > low && start < high;
    const double a = (low - start) / step, b = (high - start) / step;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
    return from < to;
}

}  // namespace

bool Box::overlaps(const Box& other) const {
    return low[0] < other.high[0] && other.low[0] < high[0] && low[1] < other.high[1] && other.low[1] < high[1];
}

bool Box::holds(const Box& other) const {
    return low[0] <= other.low[0] && low[1] <= other.low[1] && high[0] >= other.high[0] && high[1] >= other.high[1];
}

bool Box::meets(const Point& a, const Point& b) const {
    double from = 0.0, to = 1.0;
    return clip(a[0], b[0] - a[0], low[0], high[0], from, to) && clip(a[1], b[1] - a[1], low[1], high[1], from, to);
}

double width_of(const std::string& words, double size) { return kLetter * size * static_cast<double>(core::letters(words)); }

Box box_of(const Text& text) {
    const double width = width_of(text.words, text.size), before = text.align == Align::kLeft     ? 0.0
                                                                   : text.align == Align::kMiddle ? 0.5
                                                                                                  : 1.0;
    const double from = -before * width, to = from + width, up = kAscent * text.size, down = kDescent * text.size;
    const auto [x, y] = text.at;
    if (text.upright) return {{x - up, y - to}, {x + down, y - from}};
    return {{x + from, y - up}, {x + to, y + down}};
}

bool Sheet::clear(const Box& box) const {
    const auto on_text = [&](const Text& t) { return box_of(t).overlaps(box); };
    const auto on_stroke = [&](const Stroke& s) {
        const std::size_t n = s.line.size();
        for (std::size_t i = s.closed ? 0 : 1; i < n; ++i)
            if (box.meets(s.line[(i + n - 1) % n], s.line[i])) return true;
        return false;
    };
    return std::none_of(texts.begin(), texts.end(), on_text) && std::none_of(strokes.begin(), strokes.end(), on_stroke);
}

void Sheet::write_clear(const std::vector<Text>& candidates) {
    const auto found = std::find_if(candidates.begin(), candidates.end(), [this](const Text& t) { return clear(box_of(t)); });
    texts.push_back(found == candidates.end() ? candidates.back() : *found);
}

}  // namespace fusee::drawing
