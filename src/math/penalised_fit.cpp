#include "penalised_fit.h"

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>

namespace fusee::math {

double PenalisedFit::Result::score(double rows) const {
    const double left = rows - 1.4 * parameters;
    return left > 0.0 ? rows * residual / (left * left) : std::numeric_limits<double>::infinity();
}

double PenalisedFit::choose_lambda() const {
    constexpr double kLow = -9.0, kHigh = 9.0, kStep = 0.5;  // decades around the weight that balances data and penalty
    const auto score = [this](double decade) { return solve(scale_ * std::pow(10.0, decade)).score(rows_); };
    double best = kHigh, least = score(kHigh);  // ties and useless rows: the smoothest
    for (double decade = kHigh - kStep; decade >= kLow; decade -= kStep)
        if (const double now = score(decade); now < least) least = now, best = decade;
    constexpr int kBits = 12;  // a thousandth of a decade is finer than the score resolves
    const auto refined = boost::math::tools::brent_find_minima(score, best - kStep, best + kStep, kBits);
    return scale_ * std::pow(10.0, refined.second < least ? refined.first : best);
}

std::unique_ptr<const PenalisedFit> make_penalised_fit(const std::vector<PenalisedFit::Row>& rows, std::size_t count) {
    constexpr double kMostDense = 1e7;  // some 50 weights in about a second
    const double work = static_cast<double>(rows.size()) * static_cast<double>(count * count);
    return work <= kMostDense ? make_dense_fit(rows, count) : make_banded_fit(rows, count);
}

}  // namespace fusee::math
