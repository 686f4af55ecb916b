#include <fmt/format.h>

#include <array>
#include <map>

#include "answer.h"
#include "gap_map.h"

namespace fusee::diagnosis {

namespace {

constexpr std::size_t kMostPoints = 400;  ///< of a trace: enough for a picture

/// Every column of every experiment as one trace, thinned; parts that are drawn apart (a side, a spring, a level) as traces of their own.
struct TraceMaker {
    const inference::Problem& problem;
    const joint_model::Signals before, after;
    std::map<std::string, Trace> traces;

    void add(gap_case::Experiment experiment, const std::string& label, const std::string& y, double x, std::size_t figure) {
        Trace& trace = traces[std::to_string(static_cast<int>(experiment)) + label];
        trace.experiment = to_string(experiment);
        trace.label = label;
        trace.x_name = variable_of(experiment);
        trace.y_name = y;
        trace.x.push_back(x);
        trace.measured.push_back(problem.measured()[experiment][figure]);
        trace.before.push_back(before[experiment][figure]);
        trace.after.push_back(after[experiment][figure]);
        trace.sigma.push_back(problem.known().sigma[experiment][figure]);
    }
};

Trace thinned(const Trace& trace) {
    const std::size_t stride = (trace.x.size() + kMostPoints - 1) / kMostPoints;
    if (stride <= 1) return trace;
    Trace thin{trace.experiment, trace.label, trace.x_name, trace.y_name, {}, {}, {}, {}, {}};
    for (std::size_t i = 0; i < trace.x.size(); i += stride) {
        thin.x.push_back(trace.x[i]);
        thin.measured.push_back(trace.measured[i]);
        thin.before.push_back(trace.before[i]);
        thin.after.push_back(trace.after[i]);
        thin.sigma.push_back(trace.sigma[i]);
    }
    return thin;
}

}  // namespace

void Answer::traces() {
    const gap_case::Rows& rows = problem_.gap_case().rows;
    const inference::Fit& best = shown();
    TraceMaker maker{problem_, nominal_, problem_.predict(best.causes, best.x), {}};
    const std::vector<Place> all = places(rows);
    std::array<std::size_t, gap_case::kExperiments> next{};
    for (const Place& place : all) {
        const std::size_t figure = next[static_cast<std::size_t>(place.experiment)]++;
        const std::vector<std::string> columns = joint_model::measured_columns(place.experiment, rows);
        std::string label = place.component;
        if (place.experiment == gap_case::Experiment::kJointStiffness)
            label += fmt::format(" at {:g} Nm", rows.joint_stiffness[figure].cocontraction);
        maker.add(place.experiment, label, columns[figure % columns.size()], place.at, figure);
    }
    for (const auto& [key, trace] : maker.traces) diagnosis_.traces.push_back(thinned(trace));
}

}  // namespace fusee::diagnosis
