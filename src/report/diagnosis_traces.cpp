#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "diagnosis_page.h"
#include "diagnosis_words.h"
#include "fusee/math/statistics.h"
#include "html.h"
#include "svg_plot.h"

namespace fusee::report {

namespace {

using gap::Trace;
using Values = std::vector<double>;

constexpr double kSigmasOf95 = 1.959964;     // two-sided 95 % of a normal distribution
constexpr double kAlike = 0.1;               // of sigma: predictions that repeats share
constexpr std::size_t kMostTurns = 12;       // more bands than these over one another hide the lines
constexpr double kScattered = 0.2;           // of the range of x: mean step of rows in no order
constexpr double kJump = 0.5, kSteps = 3.0;  // of the range of x, and of the usual step: where a line begins anew
constexpr std::size_t kFewestPoints = 20;

bool any_known(const Values& values) {
    return std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// Column `of` in the order of `rows`; NaN where it is too short.
Values picked(const Values& of, const std::vector<std::size_t>& rows) {
    Values out;
    out.reserve(rows.size());
    for (const std::size_t i : rows) out.push_back(i < of.size() ? of[i] : gap::kNoFigure);
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

/// True if rows of equal x share their prediction, and some x comes again: repeats of a curve, not the two ways of a loop.
bool is_repeats(const Trace& trace, const std::vector<std::size_t>& by_x) {
    const Values &predicted = any_known(trace.after) ? trace.after : trace.before, x = picked(trace.x, by_x), y = picked(predicted, by_x),
                 sigma = picked(trace.sigma, by_x);
    bool again = false;
    for (std::size_t i = 1; i < x.size(); ++i) {
        if (x[i] != x[i - 1]) continue;
        if (std::abs(y[i] - y[i - 1]) > kAlike * sigma[i]) return false;
        again = true;
    }
    return again;
}

/// True if x goes to and fro in steps too long for a path.
bool is_scattered(const Values& x) {
    if (turns(x) <= kMostTurns) return false;
    double length = 0.0;
    for (std::size_t i = 1; i < x.size(); ++i) length += std::abs(x[i] - x[i - 1]);
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    return length > kScattered * (*high - *low) * static_cast<double>(x.size());
}

/// The rows to draw, in the order of their path; by rising x if they have no path.
std::vector<std::size_t> drawn_rows(const Trace& trace, std::size_t most) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < trace.x.size(); i += (trace.x.size() + most - 1) / most)
        if (std::isfinite(trace.x[i])) rows.push_back(i);
    std::vector<std::size_t> by_x = rows;
    std::stable_sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) { return trace.x[a] < trace.x[b]; });
    return is_repeats(trace, by_x) || is_scattered(picked(trace.x, rows)) ? by_x : rows;
}

/// True where the line must not go on to row i: a new sweep begins there.
std::vector<bool> starts(const Values& x) {
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
Values broken(const Values& values, const std::vector<bool>& fresh) {
    Values out;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (fresh[i]) out.push_back(gap::kNoFigure);
        out.push_back(values[i]);
    }
    return out;
}

/// One band for each way there or back: a band that folds over itself would cancel itself out.
void add_bands(Plot& plot, const Values& x, const Values& after, const Values& sigma, const std::vector<bool>& fresh) {
    Values at, low, high;
    double last = 0.0;
    const auto flush = [&] {
        if (at.size() > 1) plot.band("95 % of what is predicted", at, low, high, "se");
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

std::string chart(const Trace& trace, std::size_t most) {
    const std::vector<std::size_t> rows = drawn_rows(trace, most);
    const Values x = picked(trace.x, rows), after = picked(trace.after, rows), before = picked(trace.before, rows);
    const std::vector<bool> fresh = starts(x);
    Plot plot(trace.label, column_name(trace.x_name), column_name(trace.y_name));
    if (any_known(after) && turns(x) <= kMostTurns) add_bands(plot, x, after, picked(trace.sigma, rows), fresh);
    if (any_known(before)) plot.curve("before", broken(x, fresh), broken(before, fresh), "pe", true);
    if (any_known(after)) plot.curve("after", broken(x, fresh), broken(after, fresh), "se");
    Values measured = picked(trace.measured, rows);  // more dots than these would cover the lines
    const std::size_t step = (rows.size() + kMostDotsOfATrace - 1) / kMostDotsOfATrace;
    for (std::size_t i = 0; i < measured.size(); ++i)
        if (i % step != 0) measured[i] = gap::kNoFigure;
    return plot.points("measured", x, measured, "sum").svg();
}

}  // namespace

std::size_t drawn_points(std::size_t traces) {
    return std::clamp(kMostPoints / std::max<std::size_t>(1, traces), kFewestPoints, kMostPointsOfATrace);
}

std::string trace_section(const gap::Diagnosis& diagnosis) {
    const std::size_t most = drawn_points(diagnosis.traces.size());
    std::vector<std::string> experiments;
    bool thinned = false;
    for (const Trace& trace : diagnosis.traces) {
        thinned = thinned || trace.x.size() > std::min(most, kMostDotsOfATrace);
        if (std::find(experiments.begin(), experiments.end(), trace.experiment) == experiments.end())
            experiments.push_back(trace.experiment);
    }
    if (experiments.empty()) return "";
    std::string out =
        "<p>Dots: measured. Dashed: the nominal model. Whole line: the model with what was found, and the band in which 95 % "
        "of the measurements should then lie; where a path turns often, the band is left out.";
    if (thinned) out += fmt::format(" Of longer tables evenly chosen rows are drawn: at most {} dots.", std::min(most, kMostDotsOfATrace));
    out += "</p>";
    for (const std::string& experiment : experiments) {
        out += "<h3 class=\"held\">" + escape(experiment_name(experiment)) + "</h3><div class=\"grid\">";
        for (const Trace& trace : diagnosis.traces)
            if (trace.experiment == experiment) out += chart(trace, most);
        out += "</div>";
    }
    return section("Measured against predicted", out);
}

}  // namespace fusee::report
