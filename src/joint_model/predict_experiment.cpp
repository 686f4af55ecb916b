#include <algorithm>

#include "experiments.h"

namespace fusee::joint_model {

namespace {

template <class V>
ReadingsOf<V> predict_motion(const RigsOf<V>& rigs, const gap_case::Rows& rows, const gap_case::Protocol& protocol,
                             gap_case::Experiment experiment) {
    switch (experiment) {
        case gap_case::Experiment::kDeadBand:
            return predict_dead_band<V>(rigs, rows, protocol);
        case gap_case::Experiment::kJointStiffness:
            return predict_joint_stiffness<V>(rigs, rows, protocol);
        case gap_case::Experiment::kCocontraction:
            return predict_cocontraction<V>(rigs, rows, protocol);
        default:
            return predict_log<V>(rigs, rows, protocol);
    }
}

/// The places of rigs that can be led together: those of a log have one delay, because commands act between the same rows.
std::vector<std::vector<std::size_t>> like_delays(std::span<const BuiltRig> rigs, gap_case::Experiment experiment) {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < rigs.size(); ++i) {
        const auto group = std::find_if(groups.begin(), groups.end(), [&](const std::vector<std::size_t>& others) {
            return experiment != gap_case::Experiment::kLog || rigs[others.front()].delay == rigs[i].delay;
        });
        if (group == groups.end())
            groups.push_back({i});
        else
            group->push_back(i);
    }
    return groups;
}

}  // namespace

std::vector<double> predict_experiment(const BuiltRig& rig, const gap_case::Rows& rows, const gap_case::Protocol& protocol,
                                       gap_case::Experiment experiment) {
    if (experiment == gap_case::Experiment::kBreakAway) return predict_break_away(rig, rows.breakaway, protocol);
    if (experiment == gap_case::Experiment::kSpringPull) return predict_spring_pull(rig, rows, protocol);
    return predict_motion<double>({&rig}, rows, protocol, experiment)[0];
}

std::vector<std::vector<double>> predict_experiment(std::span<const BuiltRig> rigs, const gap_case::Rows& rows,
                                                    const gap_case::Protocol& protocol, gap_case::Experiment experiment) {
    if (rigs.size() == 1) return {predict_experiment(rigs[0], rows, protocol, experiment)};
    std::vector<std::vector<double>> all(rigs.size());
    const bool moves = experiment != gap_case::Experiment::kBreakAway && experiment != gap_case::Experiment::kSpringPull;
    for (const std::vector<std::size_t>& group : like_delays(rigs, experiment))
        for (std::size_t first = 0; first < group.size(); first += kWidth<Lanes>) {
            const std::size_t here = std::min(kWidth<Lanes>, group.size() - first);
            if (!moves || here == 1) {
                for (std::size_t i = 0; i < here; ++i)
                    all[group[first + i]] = predict_experiment(rigs[group[first + i]], rows, protocol, experiment);
                continue;
            }
            RigsOf<Lanes> four{};
            for (std::size_t l = 0; l < four.size(); ++l) four[l] = &rigs[group[first + std::min(l, here - 1)]];
            ReadingsOf<Lanes> read = predict_motion<Lanes>(four, rows, protocol, experiment);
            for (std::size_t l = 0; l < here; ++l) all[group[first + l]] = std::move(read[l]);
        }
    return all;
}

}  // namespace fusee::joint_model
