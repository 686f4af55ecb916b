#include "data/csv.h"

#include "fusee/report/search.h"

namespace fusee::report {

std::string figure_9_csv(const std::vector<CostCurve>& costs) {
    std::string csv = "variable,value,cost,feasible\n";
    for (const CostCurve& curve : costs)
        for (std::size_t i = 0; i < curve.value.size(); ++i)
            add_csv_row(csv, curve.variable, curve.value[i], curve.cost[i], curve.feasible[i] ? 1 : 0);
    return csv;
}

std::string history_csv(const std::vector<double>& history) {
    std::string csv = "generation,best_cost\n";
    for (std::size_t i = 0; i < history.size(); ++i) add_csv_row(csv, i, history[i]);
    return csv;
}

}  // namespace fusee::report
