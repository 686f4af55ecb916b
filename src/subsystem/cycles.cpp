#include "cycles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fusee/math/statistics.h"

namespace fusee::subsystem {

namespace {

constexpr std::size_t kPhases = Cycles::kPhases;
constexpr double kLikePeriods = 0.05;     // relative; beyond it, the input is not periodic
constexpr double kLikeAmplitudes = 0.05;  // relative
constexpr double kMostSteps = 16.0;       // for each of the kPhases bins: 1024 rows of a cycle

/// Times at which the input rises through `middle`, after having been below it by a tenth of the amplitude.
std::vector<double> rises(const std::vector<double>& time, const std::vector<double>& input, double middle, double amplitude) {
    std::vector<double> at;
    bool below = false;
    for (std::size_t i = 1; i < input.size(); ++i) {
        if (input[i] < middle - 0.1 * amplitude) below = true;
        if (!below || input[i] < middle) continue;
        const double step = input[i] - input[i - 1];
        at.push_back(step > 0.0 ? time[i] - (time[i] - time[i - 1]) * (input[i] - middle) / step : time[i]);
        below = false;
    }
    return at;
}

/// One cycle, and how far the input went in it.
struct Span {
    double begin, end;
    double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
};

/// The spans with the usual duration and range: an input that begins from rest or decays has none.
std::vector<Span> usual_spans(std::vector<Span> spans) {
    if (spans.empty()) return spans;
    std::vector<double> lengths, ranges;
    for (const Span& s : spans) lengths.push_back(s.end - s.begin), ranges.push_back(s.high - s.low);
    const double length = math::upper_median(std::move(lengths)), range = math::upper_median(std::move(ranges));
    std::erase_if(spans, [&](const Span& s) {
        return std::abs(s.end - s.begin - length) > kLikePeriods * length || std::abs(s.high - s.low - range) > kLikeAmplitudes * range;
    });
    return spans;
}

double median_length(const std::vector<Span>& spans) {
    std::vector<double> lengths;
    for (const Span& s : spans) lengths.push_back(s.end - s.begin);
    return math::upper_median(std::move(lengths));
}

/// The measured column at `steps` even phases of one cycle, straight between rows.
std::vector<double> loop_of(const std::vector<double>& time, const std::vector<double>& measured, const Span& span, std::size_t steps) {
    std::vector<double> loop(steps);
    for (std::size_t i = 0; i < steps; ++i) {
        const double t = span.begin + (span.end - span.begin) * (static_cast<double>(i) + 0.5) / static_cast<double>(steps);
        const auto after = static_cast<std::size_t>(std::upper_bound(time.begin() + 1, time.end() - 1, t) - time.begin());
        const double share = (t - time[after - 1]) / (time[after] - time[after - 1]);
        loop[i] = (1.0 - share) * measured[after - 1] + share * measured[after];
    }
    return loop;
}

}  // namespace

Cycles find_cycles(const std::vector<double>& time, const std::vector<double>& input, const std::vector<double>& measured) {
    Cycles cycles;
    const auto [low, high] = std::minmax_element(input.begin(), input.end());
    cycles.amplitude = 0.5 * (*high - *low);
    const std::vector<double> at = rises(time, input, 0.5 * (*high + *low), cycles.amplitude);
    std::vector<Span> spans;
    for (std::size_t c = 0; c + 1 < at.size(); ++c) spans.push_back({at[c], at[c + 1]});
    for (std::size_t i = 0, c = 0; i < time.size() && c < spans.size(); ++i) {
        if (time[i] >= spans[c].end) ++c;
        if (c == spans.size() || time[i] < spans[c].begin) continue;
        spans[c].low = std::min(spans[c].low, input[i]);
        spans[c].high = std::max(spans[c].high, input[i]);
    }
    const std::size_t found = spans.size();
    spans = usual_spans(std::move(spans));
    if (spans.empty() || 2 * spans.size() < found) return cycles;
    cycles.begin = spans.front().begin;
    cycles.period = median_length(spans);
    const double rows = static_cast<double>(time.size()) * cycles.period / (time.back() - time.front());
    const auto steps = static_cast<std::size_t>(std::clamp(rows / kPhases, 1.0, kMostSteps)) * kPhases;
    std::vector<std::vector<double>> loops;
    for (const Span& span : spans) loops.push_back(loop_of(time, measured, span, steps));
    cycles.mean.assign(kPhases, 0.0);
    const double n = static_cast<double>(loops.size());
    for (std::size_t i = 0; i < steps; ++i) {
        double sum = 0.0, squares = 0.0;
        for (const auto& loop : loops) sum += loop[i];
        for (const auto& loop : loops) squares += std::pow(loop[i] - sum / n, 2);
        cycles.mean[i * kPhases / steps] += sum / n * static_cast<double>(kPhases) / static_cast<double>(steps);
        cycles.variance += squares;
    }
    cycles.freedom = (loops.size() - 1) * steps;
    cycles.variance = cycles.freedom > 0 ? cycles.variance / static_cast<double>(cycles.freedom) : 0.0;
    return cycles;
}

const Cycles& first_of_same_amplitude(const std::vector<Cycles>& files, const Cycles& file) {
    for (const Cycles& other : files)
        if (std::abs(other.amplitude - file.amplitude) <= kLikeAmplitudes * other.amplitude) return other;
    return file;
}

double setup_variance(const std::vector<Cycles>& files) {
    double squares = 0.0, freedom = 0.0;
    for (const Cycles& first : files) {
        std::vector<const Cycles*> equal;
        for (const Cycles& file : files)
            if (file.period > 0.0 && &first_of_same_amplitude(files, file) == &first) equal.push_back(&file);
        if (equal.size() < 2) continue;
        for (std::size_t p = 0; p < kPhases; ++p) {
            double mean = 0.0;
            for (const Cycles* file : equal) mean += file->mean[p] / static_cast<double>(equal.size());
            for (const Cycles* file : equal) squares += std::pow(file->mean[p] - mean, 2);
            freedom += static_cast<double>(equal.size()) - 1.0;
        }
    }
    return freedom > 0.0 ? squares / freedom : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace fusee::subsystem
