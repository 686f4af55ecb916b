#include "fusee/paper/paper.h"

#include <algorithm>
#include <cmath>

namespace fusee::paper {

bool NoiseCurve::monotone() const {
    for (std::size_t i = 0; i < c.size(); ++i)
        if (slope[i] > 1e-9 * joint[i] / c[i]) return false;
    return true;
}

double HillFigure::largest_difference() const {
    double largest = 0.0;
    for (const Row& row : rows) largest = std::max(largest, std::abs(row.series - row.parallel));
    return largest;
}

bool PaperTable::rises() const {
    const auto& rows = simulation.measured;
    return std::is_sorted(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.measured < b.measured; });
}

}  // namespace fusee::paper
