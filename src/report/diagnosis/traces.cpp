#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "diagnosis/page.h"
#include "diagnosis/words.h"
#include "fusee/math/statistics.h"
#include "page/html.h"
#include "page/svg_plot.h"

namespace fusee::report {

namespace {

using diagnosis::Trace;
using Values = std::vector<double>;

constexpr double kSigmasOf95 = 1.959964;     // two-sided 95 % of a normal distribution
constexpr double kSamePrediction = 0.1;      // of sigma: of repeats
constexpr std::size_t kMostTurns = 12;       // more overlapping bands hide the lines
constexpr double kScattered = 0.2;           // of the range of x: mean step of unordered rows
constexpr double kJump = 0.5, kSteps = 3.0;  // of the range of x, and of the usual step: where a new line begins
constexpr std::size_t kFewestPoints = 20;

bool any_known(const Values& values) {
    return std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// Column `of` in the order of `rows`; NaN where it is too short.
Values picked(const Values& of, const std::vector<std::size_t>& rows) {
    Values out;
    out.reserve(rows.size());
    for (const std::size_t i : rows) out.push_back(i < of.size() ? of[i] : diagnosis::kNoFigure);
    return out;
}

std::size_t turns(const Values& x) {
    std::size_t count = 0;
    double last = 0.0;
    for (std::size_t i = 1; i < x.size(); ++i) {
        const double step = x[i] - x[i - 1];
        if (step * last < 0.0) ++count;
        if (step != 0.0) last = step;
    }
    return count;
}

/// True if some x repeats and rows of equal x have equal predictions: repeats of a curve, not the two branches of a loop.
bool is_repeats(const Trace& trace, const std::vector<std::size_t>& by_x) {
    const Values &predicted = any_known(trace.after) ? trace.after : trace.before, x = picked(trace.x, by_x), y = picked(predicted, by_x),
                 sigma = picked(trace.sigma, by_x);
    bool again = false;
    for (std::size_t i = 1; i < x.size(); ++i) {
        if (x[i] != x[i - 1]) continue;
        if (std::abs(y[i] - y[i - 1]) > kSamePrediction * sigma[i]) return false;
        again = true;
    }
    return again;
}

/// True if x alternates in steps too long for a path.
bool is_scattered(const Values& x) {
    if (turns(x) <= kMostTurns) return false;
    double length = 0.0;
    for (std::size_t i = 1; i < x.size(); ++i) length += std::abs(x[i] - x[i - 1]);
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    return length > kScattered * (*high - *low) * static_cast<double>(x.size());
}

/// The rows to draw in the order of their path, or by rising x without a path.
std::vector<std::size_t> drawn_rows(const Trace& trace, std::size_t most) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < trace.x.size(); i += (trace.x.size() + most - 1) / most)
        if (std::isfinite(trace.x[i])) rows.push_back(i);
    std::vector<std::size_t> by_x = rows;
    std::stable_sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) { return trace.x[a] < trace.x[b]; });
    return is_repeats(trace, by_x) || is_scattered(picked(trace.x, rows)) ? by_x : rows;
}

/// True where row i begins a new sweep, so that no line leads to it.
std::vector<bool> sweep_starts(const Values& x) {
    std::vector<bool> fresh(x.size(), false);
    if (x.size() < 3) return fresh;
    Values steps;
    for (std::size_t i = 1; i < x.size(); ++i) steps.push_back(std::abs(x[i] - x[i - 1]));
    const double usual = math::upper_median(steps);
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    for (std::size_t i = 1; i < x.size(); ++i) fresh[i] = steps[i - 1] > kJump * (*high - *low) && steps[i - 1] > kSteps * usual;
    return fresh;
}

/// A column with a gap before each new sweep.
Values with_gaps(const Values& values, const std::vector<bool>& fresh) {
    Values out;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (fresh[i]) out.push_back(diagnosis::kNoFigure);
        out.push_back(values[i]);
    }
    return out;
}

/// One band for each direction: a band that folds over itself would cancel itself.
void add_bands(Plot& plot, const Values& x, const Values& after, const Values& sigma, const std::vector<bool>& fresh) {
    Values at, low, high;
    double last = 0.0;
    const auto flush = [&] {
        if (at.size() > 1) plot.band("95 % of predicted measurements", at, low, high, "se");
    };
    const auto clear = [&] {
        flush();
        at.clear();
        low.clear();
        high.clear();
        last = 0.0;
    };
    const auto add = [&](std::size_t i) {
        at.push_back(x[i]);
        low.push_back(after[i] - kSigmasOf95 * sigma[i]);
        high.push_back(after[i] + kSigmasOf95 * sigma[i]);
    };
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double step = i == 0 ? 0.0 : x[i] - x[i - 1];
        if (fresh[i]) {
            clear();
        } else if (step * last < 0.0) {
            clear();
            add(i - 1);
        }
        if (step != 0.0 && !fresh[i]) last = step;
        add(i);
    }
    flush();
}

std::string trace_chart(const Trace& trace, std::size_t most) {
    const std::vector<std::size_t> rows = drawn_rows(trace, most);
    const Values x = picked(trace.x, rows), after = picked(trace.after, rows), before = picked(trace.before, rows);
    const std::vector<bool> fresh = sweep_starts(x);
    Plot plot(experiment_name(trace.experiment) + ": " + trace.label, column_name(trace.x_name), column_name(trace.y_name));
    if (any_known(after) && turns(x) <= kMostTurns) add_bands(plot, x, after, picked(trace.sigma, rows), fresh);
    if (any_known(before)) plot.curve("before", with_gaps(x, fresh), with_gaps(before, fresh), "pe", true);
    if (any_known(after)) plot.curve("after", with_gaps(x, fresh), with_gaps(after, fresh), "se");
    Values measured = picked(trace.measured, rows);  // more dots would cover the lines
    const std::size_t step = (rows.size() + kMostDotsOfATrace - 1) / kMostDotsOfATrace;
    for (std::size_t i = 0; i < measured.size(); ++i)
        if (i % step != 0) measured[i] = diagnosis::kNoFigure;
    return plot.points("measured", x, measured, "sum").svg();
}

}  // namespace

std::size_t drawn_points(std::size_t traces) {
    return std::clamp(kMostPoints / std::max<std::size_t>(1, traces), kFewestPoints, kMostPointsOfATrace);
}

namespace {

constexpr std::size_t kMostTelling = 4;

/// Sum of the squares of (measured - predicted)/sigma over the rows that have all three.
double squared_gap(const Trace& trace, const Values& predicted) {
    double sum = 0.0;
    for (std::size_t i = 0; i < std::min({trace.measured.size(), predicted.size(), trace.sigma.size()}); ++i)
        if (const double gap = (trace.measured[i] - predicted[i]) / trace.sigma[i]; std::isfinite(gap)) sum += gap * gap;
    return sum;
}

std::string trace_words(const std::vector<Trace>& traces, std::size_t most) {
    const bool thinned =
        std::any_of(traces.begin(), traces.end(), [&](const Trace& trace) { return trace.x.size() > std::min(most, kMostDotsOfATrace); });
    std::string words =
        "Dots: measured. Dashed: the nominal model. Solid: the model with the effects found, and the band that should contain 95 % of the "
        "measurements; without a band where a path turns often.";
    if (thinned) words += fmt::format(" Long tables show evenly chosen rows: at most {} dots.", std::min(most, kMostDotsOfATrace));
    return words;
}

}  // namespace

std::vector<std::size_t> most_telling(const std::vector<Trace>& traces, std::size_t most) {
    std::vector<double> gain;
    for (const Trace& trace : traces) {
        const double before = squared_gap(trace, trace.before);
        gain.push_back(any_known(trace.after) ? before - squared_gap(trace, trace.after) : before);
    }
    std::vector<std::size_t> order(traces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return gain[a] > gain[b]; });
    order.resize(std::min(most, order.size()));
    return order;
}

std::string trace_section(const diagnosis::Diagnosis& diagnosis) {
    const std::vector<Trace>& traces = diagnosis.traces;
    if (traces.empty()) return "";
    const std::size_t most = drawn_points(traces.size());
    const std::vector<std::size_t> first = most_telling(traces, kMostTelling);
    std::string charts;
    for (const std::size_t i : first) charts += trace_chart(traces[i], most);
    std::string out = grid(charts) + faint_paragraph(trace_words(traces, most));
    std::vector<std::string> experiments;
    for (const Trace& trace : traces)
        if (std::find(experiments.begin(), experiments.end(), trace.experiment) == experiments.end())
            experiments.push_back(trace.experiment);
    for (const std::string& experiment : experiments) {
        std::size_t count = 0;
        charts.clear();
        for (std::size_t i = 0; i < traces.size(); ++i) {
            if (traces[i].experiment != experiment || std::find(first.begin(), first.end(), i) != first.end()) continue;
            charts += trace_chart(traces[i], most);
            ++count;
        }
        if (count > 0) out += folded(fmt::format("{}: {} more", experiment_name(experiment), counted(count, "chart")), grid(charts));
    }
    return section("Measured against predicted", out);
}

}  // namespace fusee::report
