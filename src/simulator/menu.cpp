#include "menu.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "ports.h"

namespace fusee::simulator {

namespace {

constexpr std::size_t kMostRuns = 4;     // of an experiment: each costs a simulation for each change and each rival
constexpr std::size_t kMostDrawn = 400;  // of a run that are compared, as many as a trace draws
constexpr double kSetUp_min = 1.0;       // to start a run
constexpr double kMinute_s = 60.0;
constexpr double kSlower = 2.0, kTwice = 2.0, kFar = 4.0;  // times what was done; beyond it a rig has its stops and limits

/// column * factor + by
struct Change {
    double factor = 1.0, by = 0.0;
    std::string how;
};

/// Lowest and highest value in every run.
core::Range range_of(const Experiment& experiment, const std::string& column) {
    core::Range range{experiment.runs.front().columns.at(column).front(), experiment.runs.front().columns.at(column).front()};
    for (const Run& run : experiment.runs)
        for (const double value : run.columns.at(column)) range = {std::min(range.low, value), std::max(range.high, value)};
    return range;
}

std::vector<Change> changes_of(const std::string& column, const core::Range& range) {
    const std::string unit = unit_in(column), after = unit == "1" ? "" : " " + unit;
    const double span = range.width();
    std::vector<Change> changes{{0.0, 0.0, fmt::format("with {} at 0", column)},
                                {kTwice, 0.0, fmt::format("with {} {:g} times as large", column, kTwice)}};
    if (span > 0.0) {
        changes.push_back({1.0, span, fmt::format("with {} {:.3g}{} higher", column, span, after)});
        changes.push_back({1.0, -span, fmt::format("with {} {:.3g}{} lower", column, span, after)});
    }
    changes.push_back({kFar, 0.0, fmt::format("with {} {:g} times as large", column, kFar)});
    return changes;
}

Experiment changed_in(Experiment experiment, const std::string& column, const Change& change) {
    for (Run& run : experiment.runs)
        for (double& value : run.columns[column]) value = value * change.factor + change.by;
    return experiment;
}

}  // namespace

RunsAgain::RunsAgain(const Simulated& model, const Case& of_case) : model_(model) {
    for (Experiment experiment : of_case.experiments) {
        experiment.runs.resize(std::min(kMostRuns, experiment.runs.size()));
        const std::string time = experiment.time();
        if (!time.empty()) {
            add(changed_in(experiment, time, {kSlower, 0.0, ""}), time, "at half the speed");
            add(changed_in(experiment, time, {1.0 / kSlower, 0.0, ""}), time, "at twice the speed");
        }
        for (const std::string& column : experiment.inputs) {
            const core::Range range = range_of(experiment, column);
            if (column == time || is_begin(column) || (range.low == 0.0 && range.high == 0.0)) continue;
            for (const Change& change : changes_of(column, range)) add(changed_in(experiment, column, change), column, change.how);
        }
    }
}

void RunsAgain::add(const Experiment& changed, const std::string& column, const std::string& how) {
    Changed own{changed, {}, 0};
    const std::string time = changed.time();
    const core::Range range = range_of(changed, column);
    for (const Run& run : changed.runs) {
        const std::size_t stride = (run.rows() + kMostDrawn - 1) / kMostDrawn;
        inference::Measurement next;
        next.experiment = changed.name;
        next.what = fmt::format("Run {} again {}", run.file, how);
        next.variable = column;
        next.set_points = {range.low, range.high};
        next.cost = kSetUp_min;
        if (!time.empty()) next.cost += (run.columns.at(time).back() - run.columns.at(time).front()) / kMinute_s;
        for (std::size_t i = 0; i < run.rows(); i += stride)
            for (const Output& output : changed.outputs) {
                next.values.push_back(static_cast<int>(precisions_.size()));
                precisions_.push_back(std::sqrt(static_cast<double>(stride)) / output.sigma);
            }
        own.strides.push_back(stride);
        own.values += next.values.size();
        measurements_.push_back(std::move(next));
    }
    changed_.push_back(std::move(own));
}

std::vector<double> RunsAgain::predict(const inference::Setting& setting) const {
    std::vector<double> all;
    for (const Changed& own : changed_) try {
            const std::vector<Experiment> seen = model_.predict_at(setting, {own.experiment});
            const std::vector<Run>& runs = seen.front().runs;
            for (std::size_t r = 0; r < runs.size(); ++r)
                for (std::size_t i = 0; i < runs[r].rows(); i += own.strides[r])
                    for (const Output& output : own.experiment.outputs) all.push_back(runs[r].columns.at(output.name)[i]);
        } catch (const inference::Refusal&) {
            all.insert(all.end(), own.values, std::nan(""));
        } catch (const core::InvalidInput&) {  // a program that ends on inputs that no rig has had: they are no answer to its diagnosis
            all.insert(all.end(), own.values, std::nan(""));
        }
    return all;
}

}  // namespace fusee::simulator
