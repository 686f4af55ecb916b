#include <fmt/format.h>

#include <map>
#include <tuple>

#include "fusee/joint_model/uncertainty.h"
#include "fusee/math/statistics.h"

namespace fusee::joint_model {

namespace {

/// Values of `rows` with their sigma, those with the same key together.
template <typename RowList, typename Key, typename Figure>
std::vector<math::Series> series_by(const RowList& rows, const std::vector<double>& sigma, const Key& key, const Figure& figure) {
    std::map<decltype(key(rows.front())), math::Series> all;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        math::Series& own = all[key(rows[i])];
        own.values.push_back(figure(rows[i]));
        own.sigma.push_back(sigma[i]);
    }
    std::vector<math::Series> series;
    for (auto& [at, own] : all) series.push_back(std::move(own));
    return series;
}

/// Column `c` of the three of a log.
double log_scatter(const gap_case::Case& gap_case, const std::vector<double>& sigma, double gap_case::LogRow::*figure, std::size_t c) {
    math::Series own;
    for (std::size_t i = 0; i < gap_case.rows.log.size(); ++i) {
        own.values.push_back(gap_case.rows.log[i].*figure);
        own.sigma.push_back(sigma[3 * i + c]);
    }
    return math::least_scatter({own});
}

}  // namespace

Scatter measured_scatter(const gap_case::Case& gap_case, const Signals& stated) {
    Scatter result;
    const auto take = [&](double& factor, double scatter, const char* what) {
        factor = math::noise_factor(scatter);
        if (factor > 1.0)
            result.remarks.push_back(fmt::format("{} scatter {:.2g} times as much as [sensors] states: this noise is used", what, factor));
    };
    const std::vector<double>& log = stated[gap_case::Experiment::kLog];
    take(result.encoder[0], log_scatter(gap_case, log, &gap_case::LogRow::theta_agonist, 0), "angles of the agonist's capstan");
    take(result.encoder[1], log_scatter(gap_case, log, &gap_case::LogRow::theta_antagonist, 1), "angles of the antagonist's capstan");
    take(result.encoder[2], log_scatter(gap_case, log, &gap_case::LogRow::q, 2), "angles of the joint");
    const auto pulls = series_by(
        gap_case.rows.spring_pull, stated[gap_case::Experiment::kSpringPull],
        [](const gap_case::SpringPull& row) { return std::tuple(row.series, row.side, row.load); },
        [](const gap_case::SpringPull& row) { return row.torque; });
    take(result.spring_pull, math::least_scatter(pulls), "torques of spring pulls");
    const auto repeats = series_by(
        gap_case.rows.breakaway, stated[gap_case::Experiment::kBreakAway],
        [](const gap_case::BreakAway& row) { return std::tuple(row.side, row.backdrive, row.motor_torque); },
        [](const gap_case::BreakAway& row) { return row.load_torque; });
    take(result.breakaway, math::scatter_of_repeats(repeats), "repeats of break-away torques");
    return result;
}

}  // namespace fusee::joint_model
