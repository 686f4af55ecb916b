#include "experiments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fusee/core/file.h"
#include "fusee/inference/constants.h"

namespace fusee::simulator {

namespace {

constexpr double kUnexplained = 1.5;       ///< T above which a model with this noise lacks something [sigma]
constexpr std::size_t kStretches = 8;      ///< of a run that is alone
constexpr double kFigureTolerances = 5.0;  ///< usual error of a figure that is not what was stated [its tolerance]
constexpr double kMostTolerances = 200.0;  ///< of such an error, where the tolerance is absolute
constexpr double kFarthest = 1e13;         ///< of the decades by which a limit may be stated too far

void add_run(const Experiment& experiment, std::size_t r, inference::Experiment& own) {
    const Run& run = experiment.runs[r];
    const bool alone = experiment.runs.size() == 1;
    const bool row_counts = own.variable == "row";
    const std::size_t stride = stride_of(experiment);
    for (std::size_t i = 0; i < run.rows(); i += stride, ++own.rows)
        for (const Output& output : experiment.outputs) {
            const double at = row_counts ? static_cast<double>(i + 1) : run.columns.at(own.variable)[i];
            own.measured.push_back(run.columns.at(output.name)[i]);
            own.sigma.push_back(output.sigma);
            own.places.push_back({at, output.name, alone ? output.name : fmt::format("{} of {}", output.name, run.file),
                                  static_cast<int>(alone ? i * kStretches / run.rows() : r)});
        }
}

std::vector<std::size_t> all_experiments(const Case& of_case) {
    std::vector<std::size_t> all(of_case.experiments.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

std::vector<double> starts_within(const core::Range& sizes) {
    return sizes.low < 0.0 && sizes.high > 0.0 ? std::vector<double>{1.0, -1.0}
           : sizes.high > 0.0                  ? std::vector<double>{0.5, 2.0}
                                               : std::vector<double>{-0.5, -2.0};
}

/// Distances from the nominal value to try where the usual one changes no run, in usual ones: a limit is stated far beyond what the runs
/// reach. Decades of the value itself where it goes down to 0, else of the usual distance.
std::vector<double> far_sizes(double nominal, const core::Range& sizes, double usual) {
    if (sizes.low < 0.0 && sizes.high > 0.0) return {};
    const double sign = sizes.high > 0.0 ? 1.0 : -1.0, end = sizes.high > 0.0 ? sizes.high : -sizes.low;
    const bool towards_zero = nominal * sign < 0.0 && end <= std::abs(nominal);
    std::vector<double> far;
    for (double decade = 10.0; decade < kFarthest; decade *= 10.0) {
        const double distance = towards_zero ? std::abs(nominal) * (1.0 - 1.0 / decade) : usual * decade;
        if (distance > 2.0 * usual && distance < end) far.push_back(sign * distance / usual);
    }
    if (end > 2.0 * usual) far.push_back(sign * end / usual);
    return far;
}

}  // namespace

std::size_t stride_of(const Experiment& experiment) {
    std::size_t rows = 0;
    for (const Run& run : experiment.runs) rows += run.rows();
    return std::max<std::size_t>(1, (rows + kMostCompared - 1) / kMostCompared);
}

std::vector<inference::Experiment> engine_experiments(const Case& of_case) {
    std::vector<inference::Experiment> all;
    for (const Experiment& experiment : of_case.experiments) {
        inference::Experiment& own = all.emplace_back();
        own.name = experiment.name;
        own.variable = !experiment.time().empty() ? experiment.time() : !experiment.inputs.empty() ? experiment.inputs.front() : "row";
        for (const Output& output : experiment.outputs) own.outputs.push_back(output.name);
        own.unexplained = kUnexplained;
        own.blocks = experiment.runs.size() == 1 ? "stretches" : "runs";
        for (std::size_t r = 0; r < experiment.runs.size(); ++r) add_run(experiment, r, own);
    }
    return all;
}

std::vector<inference::BuildParameter> engine_build(const Case& of_case) {
    std::vector<inference::BuildParameter> all;
    for (std::size_t p = 0; p < of_case.parameters.size(); ++p) {
        const Parameter& parameter = of_case.parameters[p];
        if (!(parameter.sigma > 0.0)) continue;
        const auto effect =
            std::find_if(of_case.effects.begin(), of_case.effects.end(), [&](const Effect& other) { return other.frees.front() == p; });
        all.push_back({parameter.name, parameter.unit, parameter.sigma, parameter.nominal});
        all.back().cause = {effect == of_case.effects.end() ? parameter.name : effect->id, "none"};
    }
    return all;
}

inference::Effect engine_effect(const Effect& effect, const Case& of_case) {
    inference::Effect own;
    own.id = effect.id;
    for (std::size_t k = 0; k < effect.frees.size(); ++k) {
        const Parameter& freed = of_case.parameters[effect.frees[k]];
        const double zero = k == 0 ? freed.nominal : 0.0;  // a size is counted from the nominal value
        const core::Range allowed{effect.ranges[k].low - zero, effect.ranges[k].high - zero};
        own.parameters.push_back({freed.name, freed.unit, effect.usual[k], allowed, k == 0 ? 0.0 : freed.nominal, {}});
        own.law += (own.law.empty() ? "" : ", ") + freed.name;
    }
    own.law = "frees " + own.law;
    own.starts = starts_within(own.parameters.front().allowed);
    own.far = far_sizes(of_case.parameters[effect.frees.front()].nominal, own.parameters.front().allowed, effect.usual.front());
    own.seen_by = all_experiments(of_case);
    own.meaning = effect.meaning;
    own.remedy = effect.remedy;
    return own;
}

inference::Effect figure_effect(const Parameter& parameter, const Case& of_case) {
    inference::Effect own;
    own.id = parameter.name;
    own.law = parameter.name + " is another figure than stated, by this size";
    const double size = std::abs(parameter.nominal);
    core::Range allowed{-kMostTolerances * parameter.sigma, kMostTolerances * parameter.sigma};
    if (parameter.relative && parameter.nominal > 0.0) allowed = {-0.8 * size, 4.0 * size};  // it keeps its sign
    if (parameter.relative && parameter.nominal < 0.0) allowed = {-4.0 * size, 0.8 * size};
    own.parameters = {{parameter.name, parameter.unit, kFigureTolerances * parameter.sigma, allowed, 0.0, {}}};
    own.starts = starts_within(allowed);
    own.seen_by = all_experiments(of_case);
    own.meaning = "This figure is not what was stated.";
    own.figure = true;
    own.least = inference::kMisstated / kFigureTolerances;
    own.remedy = "Measure it, and put the measured figure into the model.";
    return own;
}

void write_runs(const std::vector<Experiment>& experiments, const std::filesystem::path& folder) {
    for (const Experiment& experiment : experiments) {
        std::vector<std::string> names = experiment.inputs;
        for (const Output& output : experiment.outputs) names.push_back(output.name);
        for (const Run& run : experiment.runs) {
            std::string csv = fmt::format("{}\n", fmt::join(names, ","));
            for (std::size_t i = 0; i < run.rows(); ++i)
                for (const std::string& name : names)
                    csv += fmt::format("{}{}", run.columns.at(name)[i], name == names.back() ? "\n" : ",");
            core::make_folder((folder / run.file).parent_path());
            core::write_file(folder / run.file, csv);
        }
    }
}

}  // namespace fusee::simulator
