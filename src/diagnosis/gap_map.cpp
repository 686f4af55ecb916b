#include "gap_map.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace fusee::diagnosis {

namespace {

constexpr std::size_t kCells = 4;
constexpr double kStandsOut = 0.6;    ///< share of an experiment's excess that makes a component worth naming
constexpr double kLeastShare = 0.02;  ///< of the gap, below which an experiment is not listed

/// Residuals of one experiment in the order of its variable, cut into cells.
std::vector<std::vector<int>> cells_of(const inference::Problem& problem, const std::vector<Place>& places,
                                       gap_case::Experiment experiment) {
    std::vector<int> rows;
    for (int i = 0; i < problem.residuals(); ++i)
        if (places[static_cast<std::size_t>(i)].experiment == experiment) rows.push_back(i);
    std::stable_sort(rows.begin(), rows.end(),
                     [&](int a, int b) { return places[static_cast<std::size_t>(a)].at < places[static_cast<std::size_t>(b)].at; });
    std::vector<std::vector<int>> cells;
    for (std::size_t c = 0; c < kCells && rows.size() >= kCells; ++c)
        cells.emplace_back(rows.begin() + static_cast<std::ptrdiff_t>(c * rows.size() / kCells),
                           rows.begin() + static_cast<std::ptrdiff_t>((c + 1) * rows.size() / kCells));
    if (cells.empty() && !rows.empty()) cells.push_back(rows);
    return cells;
}

double mean_square(const std::vector<int>& rows, const Eigen::VectorXd& figures) {
    double sum = 0.0;
    for (const int i : rows) sum += figures[i] * figures[i];
    return sum / static_cast<double>(rows.size());
}

core::Range range_of(const std::vector<int>& rows, const std::vector<Place>& places) {
    return {places[static_cast<std::size_t>(rows.front())].at, places[static_cast<std::size_t>(rows.back())].at};
}

/// The component with most of the excess, if it dominates.
std::string component_of(const std::vector<int>& rows, const std::vector<Place>& places, const Eigen::VectorXd& gap) {
    std::map<std::string, double> excess;
    double sum = 0.0;
    for (const int i : rows) {
        const double e = std::max(0.0, gap[i] * gap[i] - 1.0);
        excess[places[static_cast<std::size_t>(i)].component] += e;
        sum += e;
    }
    const auto most = std::max_element(excess.begin(), excess.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return excess.size() > 1 && most->second > kStandsOut * sum ? most->first : "";
}

GapContribution contribution_of(const inference::Problem& problem, const std::vector<Place>& places, gap_case::Experiment experiment,
                                const Eigen::VectorXd& gap) {
    const std::vector<std::vector<int>> cells = cells_of(problem, places, experiment);
    GapContribution where{to_string(experiment), 0.0, variable_of(experiment), {}, ""};
    std::vector<double> excess;
    std::vector<int> all;
    for (const std::vector<int>& cell : cells) {
        excess.push_back(std::max(0.0, mean_square(cell, gap) - 1.0));
        where.share += excess.back() * static_cast<double>(cell.size()) * problem.known().weight[static_cast<std::size_t>(experiment)];
        all.insert(all.end(), cell.begin(), cell.end());
    }
    if (where.share <= 0.0) return where;
    const auto most = std::max_element(excess.begin(), excess.end());
    auto first = static_cast<std::size_t>(most - excess.begin()), last = first;
    while (first > 0 && excess[first - 1] > 0.5 * *most) --first;
    while (last + 1 < cells.size() && excess[last + 1] > 0.5 * *most) ++last;
    where.region = {range_of(cells[first], places).low, range_of(cells[last], places).high};
    where.component = component_of(all, places, gap);
    return where;
}

}  // namespace

const char* variable_of(gap_case::Experiment experiment) {
    switch (experiment) {
        case gap_case::Experiment::kBreakAway:
            return "motor_torque_Nm";
        case gap_case::Experiment::kSpringPull:
            return "deflection_rad";
        case gap_case::Experiment::kDeadBand:
            return "cocontraction_Nm";
        case gap_case::Experiment::kJointStiffness:
            return "joint_torque_Nm";
        case gap_case::Experiment::kCocontraction:
            return "motor_torque_Nm";
        default:
            return "t_s";
    }
}

std::vector<Place> places(const gap_case::Rows& rows) {
    std::vector<Place> all;
    const auto add_columns = [&](gap_case::Experiment experiment, double at) {
        for (const std::string& column : joint_model::measured_columns(experiment, rows)) all.push_back({experiment, at, column});
    };
    for (const identification::BreakAway& row : rows.breakaway)
        all.push_back({gap_case::Experiment::kBreakAway, row.motor_torque, row.side + (row.backdrive ? " backdrive" : " drive")});
    for (const gap_case::SpringPull& row : rows.spring_pull)
        all.push_back({gap_case::Experiment::kSpringPull, row.deflection, std::string(row.series ? "se " : "pe ") + to_string(row.side)});
    for (const gap_case::DeadBandRow& row : rows.dead_band) add_columns(gap_case::Experiment::kDeadBand, row.cocontraction);
    for (const gap_case::StiffnessRow& row : rows.joint_stiffness)
        all.push_back({gap_case::Experiment::kJointStiffness, row.joint_torque, "q_rad"});
    for (const gap_case::CocontractionRow& row : rows.cocontraction) add_columns(gap_case::Experiment::kCocontraction, row.motor_torque);
    for (const gap_case::LogRow& row : rows.log) add_columns(gap_case::Experiment::kLog, row.time);
    return all;
}

Eigen::VectorXd tolerance_sigma(const inference::Problem& problem, const Eigen::MatrixXd& build_slopes) {
    const auto build = static_cast<Eigen::Index>(problem.build().size());
    return (build_slopes.leftCols(build).rowwise().squaredNorm().array() + 1.0).sqrt();
}

double root_mean_square(const inference::Problem& problem, const Eigen::VectorXd& figures, const gap_case::Experiment* only) {
    double sum = 0.0, weights = 0.0;
    for (int i = 0; i < figures.size(); ++i) {
        const gap_case::Experiment experiment = problem.experiment_of(i);
        if (only != nullptr && experiment != *only) continue;
        const double weight = problem.known().weight[static_cast<std::size_t>(experiment)];
        sum += weight * figures[i] * figures[i];
        weights += weight;
    }
    return weights > 0.0 ? std::sqrt(sum / weights) : kNoFigure;
}

std::vector<GapCell> gap_map(const inference::Problem& problem, const Eigen::VectorXd& before, const Eigen::VectorXd& after) {
    const std::vector<Place> all = places(problem.gap_case().rows);
    std::vector<GapCell> map;
    for (const gap_case::Experiment experiment : gap_case::kAllExperiments)
        for (const std::vector<int>& cell : cells_of(problem, all, experiment))
            map.push_back({to_string(experiment), variable_of(experiment), range_of(cell, all), std::sqrt(mean_square(cell, before)),
                           std::sqrt(mean_square(cell, after)), cell.size()});
    return map;
}

std::vector<GapContribution> gap_contributions(const inference::Problem& problem, const Eigen::VectorXd& gap) {
    const std::vector<Place> all = places(problem.gap_case().rows);
    std::vector<GapContribution> where;
    double sum = 0.0;
    for (const gap_case::Experiment experiment : gap_case::kAllExperiments)
        if (problem.gap_case().rows.size(experiment) > 0) {
            where.push_back(contribution_of(problem, all, experiment, gap));
            sum += where.back().share;
        }
    if (sum <= 0.0) return {};
    for (GapContribution& part : where) part.share /= sum;
    std::erase_if(where, [](const GapContribution& part) { return part.share < kLeastShare; });
    std::stable_sort(where.begin(), where.end(), [](const GapContribution& a, const GapContribution& b) { return a.share > b.share; });
    return where;
}

}  // namespace fusee::diagnosis
