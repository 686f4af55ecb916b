#include <map>

#include "answer.h"
#include "fusee/inference/constants.h"

namespace fusee::diagnosis {

namespace {

Trace thinned(const Trace& trace) {
    const std::size_t stride = (trace.x.size() + inference::kMostPoints - 1) / inference::kMostPoints;
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

/// Every column of every experiment as one trace; what is drawn apart (a side, a spring, a level) as traces of their own.
std::vector<Trace> traces_of(const inference::Problem& problem, const inference::Outputs& before, const inference::Outputs& after) {
    std::map<std::string, Trace> traces;
    for (std::size_t e = 0; e < problem.experiments().size(); ++e) {
        const inference::Experiment& experiment = problem.experiments()[e];
        for (std::size_t i = 0; i < experiment.size(); ++i) {
            const inference::Place& place = experiment.places[i];
            Trace& trace = traces[std::to_string(e) + place.curve];
            trace.experiment = experiment.name;
            trace.label = place.curve;
            trace.x_name = experiment.variable;
            trace.y_name = experiment.outputs[i % experiment.outputs.size()];
            trace.x.push_back(place.at);
            trace.measured.push_back(experiment.measured[i]);
            trace.before.push_back(before[e][i]);
            trace.after.push_back(after[e][i]);
            trace.sigma.push_back(experiment.sigma[i]);
        }
    }
    std::vector<Trace> all;
    for (const auto& [key, trace] : traces) all.push_back(thinned(trace));
    return all;
}

}  // namespace fusee::diagnosis
