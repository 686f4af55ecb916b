#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "data/figures.h"
#include "fusee/core/lists.h"
#include "fusee/report/paper.h"

namespace fusee::report {

namespace {

std::string comma_list(const std::vector<std::string>& words) { return words.empty() ? "none" : core::listed(words); }

std::string noise_claim(const std::vector<NoiseCurve>& curves) {
    std::vector<std::string> hold, fail, unbounded;
    for (const NoiseCurve& curve : curves) (!curve.refusal.empty() ? unbounded : curve.monotone() ? hold : fail).push_back(curve.name);
    return "holds for noise at " + comma_list(hold) + "; a stiffer c passes more noise for " + comma_list(fail) + "; no bound for " +
           comma_list(unbounded);
}

std::string figure_6_claim(const Simulation& s) {
    const SimulatedDeadBand& peak = s.levels.back().dead_band;
    std::string text = fmt::format("gear friction holds the joint within {} deg at {} Nm", deg(peak.exact_width, 3), number(peak.tau));
    if (!s.path) return text;
    return text + fmt::format("; pushed up and released it rests at {} deg, pushed down at {} deg", deg(s.path->up.back().q, 3),
                              deg(s.path->down.back().q, 3));
}

/// "15.4 deg at 0.12 Nm to 89.8 deg at 1 Nm": the first and the last row where the figure is known.
std::string first_to_last(const std::vector<MeasuredRow>& rows, double SimulatedDeadBand::*figure) {
    const auto known = [figure](const MeasuredRow& row) { return std::isfinite(row.computed.*figure); };
    const auto first = std::find_if(rows.begin(), rows.end(), known);
    if (first == rows.end()) return "nothing: outside the laws of the springs";
    const auto last = std::find_if(rows.rbegin(), rows.rend(), known);
    return fmt::format("{} deg at {} Nm to {} deg at {} Nm", deg(first->computed.*figure, 3), number(first->tau),
                       deg(last->computed.*figure, 3), number(last->tau));
}

std::string table_claim(const PaperTable& table) {
    const std::vector<MeasuredRow>& rows = table.simulation.measured;
    return fmt::format("condition (6) {}; exact {}; measured by the test {}", to_string(condition_verdict(table.simulation.condition)),
                       first_to_last(rows, &SimulatedDeadBand::exact_width), first_to_last(rows, &SimulatedDeadBand::measured_width));
}

std::string measured_claim(const PaperTable& table) {
    const std::vector<MeasuredRow>& rows = table.simulation.measured;
    return fmt::format("the dead-band {} from {} deg at {} Nm to {} deg at {} Nm", table.rises() ? "rises" : "falls",
                       deg(rows.front().measured, 3), number(rows.front().tau), deg(rows.back().measured, 3), number(rows.back().tau));
}

std::string friction_claim(const Identification& found) {
    const gap_case::FrictionLine& line = found.friction.trusted();
    return fmt::format("mu = {} (95 %: {} to {}) from {} synthetic rows, {}", number(line.through_zero_mu),
                       number(line.through_zero_mu_95.low), number(line.through_zero_mu_95.high), line.rows, found.name);
}

/// Largest relative difference of the cost between u and -u; the scan is symmetric.
double asymmetry(const std::vector<CostCurve>& costs) {
    double largest = 0.0;
    for (const CostCurve& curve : costs)
        for (std::size_t i = 0; curve.variable == "u" && i < curve.cost.size(); ++i) {
            const double left = curve.cost[i], right = curve.cost[curve.cost.size() - 1 - i];
            largest = std::max(largest, std::abs(left - right) / std::max(1.0, std::abs(left)));
        }
    return largest;
}

std::string search_claim(const SearchReport& search) {
    std::string text;
    for (const SearchedVariable& v : search.variables) text += fmt::format("{} = {} {}, ", v.name, number(v.found), v.unit);
    return text + fmt::format("cost {} after {} evaluations; relative difference between u and -u: {}", number(search.cost),
                              search.evaluations, number(asymmetry(search.costs), 2));
}

std::string relatives_claim(const std::vector<actuator::ArrangementRow>& rows) {
    std::vector<std::string> held;
    for (const actuator::ArrangementRow& row : rows)
        if (row.free_stiffness.low > 0.0) held.emplace_back(to_string(row.arrangement));
    return fmt::format("of {} arrangements with equal springs under torque control, these have a defined equilibrium: {}", rows.size(),
                       comma_list(held));
}

}  // namespace

std::vector<PaperClaim> claims(const Paper& paper) {
    return {{"figure 1", "passive noise rejection grows with c; without a and b noise drives the system arbitrarily far",
             noise_claim(paper.figure_1)},
            {"figure 2", "two arrangements of one muscle",
             fmt::format("equal forces to {} Nm with linear springs", number(paper.figure_2.largest_difference(), 2))},
            {"figure 6", "the joint rests at many places at 1 Nm", figure_6_claim(paper.table_1.simulation)},
            {"figure 8", "friction in proportion to the load, mu = 0.28", friction_claim(paper.figure_8)},
            {"figure 9", "a best k, u and C; the cost is symmetric in u", search_claim(paper.figure_9)},
            {"table I", measured_claim(paper.table_1), table_claim(paper.table_1)},
            {"table II", measured_claim(paper.table_2), table_claim(paper.table_2)},
            {"relatives", "typical designs float against the ground", relatives_claim(paper.torque_control)}};
}

std::string paper_text(const Paper& paper) {
    std::string text;
    for (const PaperClaim& claim : claims(paper))
        text += fmt::format("{:10} paper: {}\n{:10} here:  {}\n", claim.piece, claim.paper, "", claim.here);
    return text;
}

}  // namespace fusee::report
