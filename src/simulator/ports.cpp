#include "ports.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace fusee::simulator {

namespace {

using Kind = Port::Kind;

constexpr double kUsualShare = 0.05;     // of the span of a column: offset, drift and dead zone; of 1: scale
constexpr double kUsualDelay_s = 0.01;   // of a bus and a loop
constexpr double kUsualDelayRows = 2.0;  // the same where rows are farther apart
constexpr double kLeastShare = 0.02;     // of what is usual: less is the accuracy of any simulator
constexpr double kLongestDelay = 0.25;   // of the shortest run
constexpr double kMostSpans = 2.0;       // of an offset or a drift
constexpr core::Range kScales{-0.8, 4.0};

/// A column in every run that has it.
struct Seen {
    std::vector<std::size_t> experiments;
    core::Range range{0.0, 0.0};
    bool any = false, output = false, timed = true;
    double row_s = 0.0, shortest_s = 0.0;  // median distance of rows, shortest run
    void add(const std::vector<double>& values) {
        for (const double value : values) {
            range = any ? core::Range{std::min(range.low, value), std::max(range.high, value)} : core::Range{value, value};
            any = true;
        }
    }
    void add_time(const std::vector<double>& time) {
        const double span = time.back() - time.front();
        shortest_s = shortest_s == 0.0 ? span : std::min(shortest_s, span);
        row_s = std::max(row_s, span / std::max(1.0, static_cast<double>(time.size()) - 1.0));
    }
};

std::map<std::string, Seen> columns_of(const Case& of_case) {
    std::map<std::string, Seen> all;
    for (std::size_t e = 0; e < of_case.experiments.size(); ++e) {
        const Experiment& experiment = of_case.experiments[e];
        const std::string time = experiment.time();
        const auto see = [&](const std::string& name, bool output) {
            Seen& seen = all[name];
            seen.experiments.push_back(e);
            seen.output = output;
            seen.timed = seen.timed && !time.empty();
            for (const Run& run : experiment.runs) {
                seen.add(run.columns.at(name));
                if (!time.empty()) seen.add_time(run.columns.at(time));
            }
        };
        for (const std::string& name : experiment.inputs)
            if (name != time && !is_begin(name)) see(name, false);
        for (const Output& output : experiment.outputs) see(output.name, true);
    }
    return all;
}

struct Words {
    Kind kind;
    const char *name, *law, *meaning, *remedy;
};
constexpr Words kWords[] = {
    {Kind::kOffset, "offset", "column + b", "Everything in this column is shifted by one constant.",
     "Set the zero of this sensor or command again."},
    {Kind::kScale, "scale", "column (1 + s)", "Everything in this column is greater (+) or smaller (-) by one factor.",
     "Calibrate this sensor or command: check its gain and its unit."},
    {Kind::kDelay, "delay", "column(t - d)", "This column is later by a constant time.",
     "Align the clocks of the log, or put the delay into the model."},
    {Kind::kDrift, "drift", "column + r (share of the run)", "This column wanders by this much from the start to the end of each run.",
     "Let it warm up, set its zero before each run, or log its temperature."},
    {Kind::kDeadZone, "dead_zone", "sign(column) max(0, |column| - w)", "The first of this command, up to this size, does nothing.",
     "Compensate the dead zone in the drive, or put it into the model."}};

inference::EffectParameter size_of(Kind kind, const std::string& column, const Seen& seen) {
    const double span = seen.range.width() > 0.0 ? seen.range.width() : std::abs(seen.range.high);
    const std::string own = unit_in(column);
    const double usual = kUsualShare * span, most = kMostSpans * span;
    switch (kind) {
        case Kind::kScale:
            return {"s", "1", kUsualShare, kScales, 0.0, {}};
        case Kind::kDelay:
            return {"d", "s", std::max(kUsualDelay_s, kUsualDelayRows * seen.row_s), {0.0, kLongestDelay * seen.shortest_s}, 0.0, {}};
        case Kind::kDeadZone:
            return {"w", own, usual, {0.0, span}, 0.0, {}};
        case Kind::kDrift:
            return {"r", own, usual, {-most, most}, 0.0, {}};
        case Kind::kOffset:
            break;
    }
    return {"b", own, usual, {-most, most}, 0.0, {}};
}

Port port_of(const Words& words, const std::string& column, const Seen& seen) {
    Port port{words.kind, column, seen.output, {}};
    port.effect.id = fmt::format("port.{}.{}", column, words.name);
    port.effect.law = words.law;
    port.effect.meaning = words.meaning;
    port.effect.remedy = words.remedy;
    port.effect.parameters = {size_of(words.kind, column, seen)};
    port.effect.starts = port.effect.parameters.front().allowed.low < 0.0 ? std::vector<double>{1.0, -1.0} : std::vector<double>{1.0, 3.0};
    port.effect.seen_by = seen.experiments;
    port.effect.least = kLeastShare;
    return port;
}

/// The value at `at`, straight between rows; the first one before them.
double value_at(const std::vector<double>& time, const std::vector<double>& values, double at) {
    const auto after = std::upper_bound(time.begin(), time.end(), at);
    if (after == time.begin()) return values.front();
    if (after == time.end()) return values.back();
    const auto i = static_cast<std::size_t>(after - time.begin());
    return values[i - 1] + (values[i] - values[i - 1]) * (at - time[i - 1]) / (time[i] - time[i - 1]);
}

}  // namespace

bool is_begin(const std::string& name) { return name.starts_with("begin_") || name.find("_begin_") != std::string::npos; }

std::vector<Port> ports_of(const Case& of_case) {
    std::vector<Port> ports;
    for (const auto& [column, seen] : columns_of(of_case)) {
        const bool changes = seen.range.width() > 0.0;
        for (const Words& words : kWords) {
            if (words.kind == (seen.output ? Kind::kDeadZone : Kind::kDrift)) continue;
            const bool needs_change = words.kind == Kind::kDelay || words.kind == Kind::kDeadZone;
            if (!changes && (needs_change || seen.range.high == 0.0)) continue;
            if (words.kind == Kind::kDelay && !(seen.timed && seen.shortest_s > 0.0)) continue;
            ports.push_back(port_of(words, column, seen));
        }
    }
    return ports;
}

void apply_port(Kind kind, double size, const std::vector<double>* time, std::vector<double>& column) {
    const std::vector<double> before = kind == Kind::kDelay ? column : std::vector<double>();
    for (std::size_t i = 0; i < column.size(); ++i) {
        double& value = column[i];
        const double share = column.size() < 2 ? 0.0
                             : time == nullptr ? static_cast<double>(i) / static_cast<double>(column.size() - 1)
                                               : ((*time)[i] - time->front()) / (time->back() - time->front());
        switch (kind) {
            case Kind::kOffset:
                value += size;
                break;
            case Kind::kScale:
                value *= 1.0 + size;
                break;
            case Kind::kDrift:
                value += size * share;
                break;
            case Kind::kDeadZone:
                value = std::copysign(std::max(0.0, std::abs(value) - size), value);
                break;
            case Kind::kDelay:
                value = value_at(*time, before, (*time)[i] - size);
        }
    }
}

}  // namespace fusee::simulator
