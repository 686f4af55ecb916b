#include "fusee/diagnosis/gap_map.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fusee/inference/constants.h"

namespace fusee::diagnosis {

namespace {

using Places = std::vector<const inference::Place*>;

/// The place of every residual.
Places places_of(const inference::Problem& problem) {
    Places all;
    for (const inference::Experiment& experiment : problem.experiments())
        for (const inference::Place& place : experiment.places) all.push_back(&place);
    return all;
}

/// Residuals of one experiment in the order of its variable, cut into cells.
std::vector<std::vector<int>> cells_of(const inference::Problem& problem, const Places& places, std::size_t experiment) {
    std::vector<int> rows;
    for (int i = 0; i < problem.residual_count(); ++i)
        if (problem.experiment_of(i) == experiment) rows.push_back(i);
    std::stable_sort(rows.begin(), rows.end(),
                     [&](int a, int b) { return places[static_cast<std::size_t>(a)]->at < places[static_cast<std::size_t>(b)]->at; });
    std::vector<std::vector<int>> cells;
    for (std::size_t c = 0; c < inference::kCells && rows.size() >= inference::kCells; ++c)
        cells.emplace_back(rows.begin() + static_cast<std::ptrdiff_t>(c * rows.size() / inference::kCells),
                           rows.begin() + static_cast<std::ptrdiff_t>((c + 1) * rows.size() / inference::kCells));
    if (cells.empty() && !rows.empty()) cells.push_back(rows);
    return cells;
}

double mean_square(const std::vector<int>& rows, const Eigen::VectorXd& figures) {
    double sum = 0.0;
    for (const int i : rows) sum += figures[i] * figures[i];
    return sum / static_cast<double>(rows.size());
}

core::Range range_of(const std::vector<int>& rows, const Places& places) {
    return {places[static_cast<std::size_t>(rows.front())]->at, places[static_cast<std::size_t>(rows.back())]->at};
}

/// The component with most of the excess, if it dominates.
std::string component_of(const std::vector<int>& rows, const Places& places, const Eigen::VectorXd& gap) {
    std::map<std::string, double> excess;
    double sum = 0.0;
    for (const int i : rows) {
        const double e = std::max(0.0, gap[i] * gap[i] - 1.0);
        excess[places[static_cast<std::size_t>(i)]->component] += e;
        sum += e;
    }
    const auto most = std::max_element(excess.begin(), excess.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return excess.size() > 1 && most->second > inference::kStandsOut * sum ? most->first : "";
}

GapContribution contribution_of(const inference::Problem& problem, const Places& places, std::size_t experiment,
                                const Eigen::VectorXd& gap) {
    const inference::Experiment& own = problem.experiments()[experiment];
    const std::vector<std::vector<int>> cells = cells_of(problem, places, experiment);
    GapContribution where{own.name, 0.0, own.variable, {}, ""};
    std::vector<double> excess;
    std::vector<int> all;
    for (const std::vector<int>& cell : cells) {
        excess.push_back(std::max(0.0, mean_square(cell, gap) - 1.0));
        where.share += excess.back() * static_cast<double>(cell.size()) * own.weight;
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

Eigen::VectorXd tolerance_sigma(const inference::Problem& problem, const Eigen::MatrixXd& build_slopes) {
    Eigen::MatrixXd slopes = build_slopes.leftCols(static_cast<Eigen::Index>(problem.build().size()));
    for (std::size_t k = 0; k < problem.build().size(); ++k)
        if (!problem.build()[k].stated) slopes.col(static_cast<Eigen::Index>(k)).setZero();
    return (slopes.rowwise().squaredNorm().array() + 1.0).sqrt();
}

double root_mean_square(const inference::Problem& problem, const Eigen::VectorXd& figures, const std::size_t* only) {
    double sum = 0.0, weights = 0.0;
    for (int i = 0; i < figures.size(); ++i) {
        const std::size_t experiment = problem.experiment_of(i);
        if (only != nullptr && experiment != *only) continue;
        const double weight = problem.experiments()[experiment].weight;
        sum += weight * figures[i] * figures[i];
        weights += weight;
    }
    return weights > 0.0 ? std::sqrt(sum / weights) : kNoFigure;
}

std::vector<GapCell> gap_map(const inference::Problem& problem, const Eigen::VectorXd& before, const Eigen::VectorXd& after) {
    const Places all = places_of(problem);
    std::vector<GapCell> map;
    for (std::size_t e = 0; e < problem.experiments().size(); ++e)
        for (const std::vector<int>& cell : cells_of(problem, all, e))
            map.push_back({problem.experiments()[e].name, problem.experiments()[e].variable, range_of(cell, all),
                           std::sqrt(mean_square(cell, before)), std::sqrt(mean_square(cell, after)), cell.size()});
    return map;
}

std::vector<GapContribution> gap_contributions(const inference::Problem& problem, const Eigen::VectorXd& gap) {
    const Places all = places_of(problem);
    std::vector<GapContribution> where;
    double sum = 0.0;
    for (std::size_t e = 0; e < problem.experiments().size(); ++e)
        if (problem.experiments()[e].rows > 0) {
            where.push_back(contribution_of(problem, all, e, gap));
            sum += where.back().share;
        }
    if (sum <= 0.0) return {};
    for (GapContribution& part : where) part.share /= sum;
    std::erase_if(where, [](const GapContribution& part) { return part.share < inference::kLeastShare; });
    std::stable_sort(where.begin(), where.end(), [](const GapContribution& a, const GapContribution& b) { return a.share > b.share; });
    return where;
}

}  // namespace fusee::diagnosis
