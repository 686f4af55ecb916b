#include "fusee/math/chebyshev.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace fusee::math {

namespace {

constexpr std::size_t kSeriesDegree = ChebyshevSeries::kPoints - 1;
using Values = ChebyshevSeries::Values;

/// Row k gives coefficient k from the values at the points: a cosine transform, the ends counted half.
const std::array<Values, ChebyshevSeries::kPoints>& transform() {
    static const auto kRows = [] {
        std::array<Values, ChebyshevSeries::kPoints> rows{};
        const auto half_at_ends = [](std::size_t i) { return i == 0 || i == kSeriesDegree ? 0.5 : 1.0; };
        for (std::size_t k = 0; k <= kSeriesDegree; ++k)
            for (std::size_t j = 0; j <= kSeriesDegree; ++j) {
                // T_k(-cos(pi j/n)) = cos(pi k (n - j)/n); the remainder keeps the argument small
                const auto turn = static_cast<double>(k * (kSeriesDegree - j) % (2 * kSeriesDegree));
                rows[k][j] = 2.0 / kSeriesDegree * half_at_ends(k) * half_at_ends(j) * std::cos(core::kPi * turn / kSeriesDegree);
            }
        return rows;
    }();
    return kRows;
}

const Values& cosines() {
    static const auto kCosines = [] {
        Values values{};
        // sin of the distance to the middle: symmetric to the last bit
        for (std::size_t j = 0; j <= kSeriesDegree; ++j)
            values[j] = std::sin(core::kPi * (2.0 * static_cast<double>(j) / kSeriesDegree - 1.0) / 2.0);
        return values;
    }();
    return kCosines;
}

}  // namespace

Values ChebyshevSeries::points(core::Range domain) {
    Values x{};
    const double middle = 0.5 * (domain.low + domain.high), half = 0.5 * domain.width();
    for (std::size_t j = 0; j <= kSeriesDegree; ++j) x[j] = middle + half * cosines()[j];
    x.front() = domain.low;
    x.back() = domain.high;
    return x;
}

ChebyshevSeries::ChebyshevSeries(core::Range domain, const Values& values) : domain_(domain) {
    double largest = 0.0;
    for (std::size_t k = 0; k <= kSeriesDegree; ++k) {
        double sum = 0.0;
        for (std::size_t j = 0; j <= kSeriesDegree; ++j) sum += transform()[k][j] * values[j];
        coefficients_[k] = sum;
        largest = std::max(largest, std::abs(sum));
    }
    count_ = kPoints;
    // Rounding in the last coefficients grows most in a derivative.
    while (count_ > 1 && std::abs(coefficients_[count_ - 1]) <= 0.5 * std::numeric_limits<double>::epsilon() * largest) --count_;
}

double ChebyshevSeries::operator()(double x) const {
    const double t = (2.0 * x - domain_.low - domain_.high) / domain_.width();
    double b1 = 0.0, b2 = 0.0;  // Clenshaw's recurrence
    for (std::size_t k = count_ - 1; k >= 1; --k) {
        const double b = coefficients_[k] + 2.0 * t * b1 - b2;
        b2 = b1;
        b1 = b;
    }
    return coefficients_[0] + t * b1 - b2;
}

Jet ChebyshevSeries::over(const Interval& x) const {
    // t beyond [-1, 1] is rounding: the box lies in the domain.
    const Interval t = common((2.0 * x - domain_.low - domain_.high) / (Interval(domain_.high) - domain_.low), Interval(-1.0, 1.0));
    const Interval angle = common(boost::numeric::acos(t), Interval(0.0, core::kPi + 1e-15));
    std::array<Interval, kPoints + 2> terms{Interval(1.0)}, slopes{};  // zeros from count_ - 1 on
    for (std::size_t k = 1; k < count_; ++k) terms[k] = boost::numeric::cos(static_cast<double>(k) * angle);
    const Interval scale = 2.0 / (Interval(domain_.high) - domain_.low);
    for (std::size_t k = count_ - 1; k >= 1; --k)  // as in derivative(), enclosed
        slopes[k - 1] = slopes[k + 1] + 2.0 * static_cast<double>(k) * scale * coefficients_[k];
    slopes[0] /= 2.0;
    Jet sum(0.0);
    for (std::size_t k = 0; k < count_; ++k) sum += {coefficients_[k] * terms[k], slopes[k] * terms[k]};
    return sum;
}

ChebyshevSeries ChebyshevSeries::derivative() const {
    ChebyshevSeries result(domain_);
    result.count_ = std::max<std::size_t>(count_ - 1, 1);
    auto& d = result.coefficients_;
    const double scale = 2.0 / domain_.width();
    for (std::size_t k = count_ - 1; k >= 1; --k)  // d_(k-1) = d_(k+1) + 2k c_k
        d[k - 1] = (k + 1 < result.count_ ? d[k + 1] : 0.0) + 2.0 * static_cast<double>(k) * scale * coefficients_[k];
    d[0] *= 0.5;
    return result;
}

ChebyshevSeries ChebyshevSeries::integral() const {
    assert(count_ <= kPoints);
    ChebyshevSeries result(domain_);
    result.count_ = count_ + 1;
    const double half = 0.5 * domain_.width();
    double at_low = 0.0;
    for (std::size_t k = 1; k <= count_; ++k) {  // (c_(k-1) - c_(k+1))/(2k), c_0 counted twice
        const double before = (k == 1 ? 2.0 : 1.0) * coefficients_[k - 1], after = k + 1 < count_ ? coefficients_[k + 1] : 0.0;
        const double b = half * (before - after) / (2.0 * static_cast<double>(k));
        result.coefficients_[k] = b;
        at_low += k % 2 == 0 ? b : -b;
    }
    result.coefficients_[0] = -at_low;
    return result;
}

double ChebyshevSeries::tail() const {
    return std::max(std::abs(coefficients_[kSeriesDegree - 1]), std::abs(coefficients_[kSeriesDegree]));
}

PiecewiseChebyshev::Piece::Piece(const ChebyshevSeries& series)
    : value(series), first(value.derivative()), second(first.derivative()), third(second.derivative()), integral(value.integral()) {}

PiecewiseChebyshev::PiecewiseChebyshev(const std::function<double(double)>& f, core::Range domain, const PiecewiseOptions& options) {
    // Starts with four pieces, so that a narrow feature is not overlooked. No cut is at a round share of the domain: neither piece would
    // detect a kink there.
    constexpr std::array kCuts{0.0, 0.2413, 0.4931, 0.7417, 1.0};
    for (std::size_t i = 0; i + 1 < kCuts.size(); ++i)
        divide(f, {std::lerp(domain.low, domain.high, kCuts[i]), std::lerp(domain.low, domain.high, kCuts[i + 1])}, options, 0);
    for (std::size_t i = 1; i < pieces_.size(); ++i) {
        const Piece& below = pieces_[i - 1];
        pieces_[i].before = below.before + below.integral(below.value.domain().high);
        if (!rough_ && !meet(below, pieces_[i], options.tolerance)) rough_ = pieces_[i].value.domain().low;
    }
}

/// A kink so close to a cut that no interpolation point lies between them leaves two smooth pieces whose derivatives do not meet. A jump
/// of the third derivative there shifts the second by a hundredth of its own size at most.
bool PiecewiseChebyshev::meet(const Piece& below, const Piece& above, double tolerance) {
    constexpr double kShare = 0.02;
    const core::Range left = below.value.domain(), right = above.value.domain();
    // Markov: a derivative grows an error by at most the degree squared, in units of half the piece.
    const double growth = static_cast<double>(kSeriesDegree * kSeriesDegree) / (0.5 * std::min(left.width(), right.width()));
    double noise = tolerance * std::max(std::abs(below.value(left.high)), std::abs(above.value(right.low)));
    for (const auto order : {&Piece::first, &Piece::second}) {
        noise *= growth;
        const double before = (below.*order)(left.high), after = (above.*order)(right.low);
        const double size =
            std::max({std::abs((below.*order)(left.low)), std::abs(before), std::abs(after), std::abs((above.*order)(right.high))});
        if (std::abs(before - after) > kShare * size + noise) return false;
    }
    return true;
}

void PiecewiseChebyshev::divide(const std::function<double(double)>& f, core::Range range, const PiecewiseOptions& options, int depth) {
    const Values x = ChebyshevSeries::points(range);
    Values y{};
    std::transform(x.begin(), x.end(), y.begin(), f);
    double largest = 0.0;
    for (const double value : y) largest = std::max(largest, std::abs(value));
    largest_ = std::max(largest_, largest);
    const ChebyshevSeries series(range, y);
    // Small values next to large ones have the rounding of the large.
    const double allowed = std::max(options.tolerance * largest, 4.0 * std::numeric_limits<double>::epsilon() * largest_);
    const double between = 0.5 * (x[5] + x[6]);  // not an interpolation point
    const bool converged = series.tail() <= allowed && std::abs(series(between) - f(between)) <= 10.0 * allowed;
    if (!converged && depth < options.deepest) {
        const double split = std::lerp(range.low, range.high, 0.4813);
        divide(f, {range.low, split}, options, depth + 1);
        divide(f, {split, range.high}, options, depth + 1);
        return;
    }
    if (!converged && !rough_) rough_ = 0.5 * (range.low + range.high);
    pieces_.emplace_back(series);
}

const PiecewiseChebyshev::Piece& PiecewiseChebyshev::piece(double x) const {
    const auto above =
        std::upper_bound(pieces_.begin(), pieces_.end(), x, [](double at, const Piece& p) { return at < p.value.domain().low; });
    return above == pieces_.begin() ? pieces_.front() : *std::prev(above);
}

double PiecewiseChebyshev::derivative(double x, int order) const {
    assert(order >= 0 && order <= 3);
    const double at = std::clamp(x, domain().low, domain().high);
    const Piece& p = piece(at);
    return order == 0 ? p.value(at) : order == 1 ? p.first(at) : order == 2 ? p.second(at) : p.third(at);
}

double PiecewiseChebyshev::integral(double x) const {
    const double at = std::clamp(x, domain().low, domain().high);
    const Piece& p = piece(at);
    return p.before + p.integral(at);
}

std::vector<double> PiecewiseChebyshev::breaks() const {
    std::vector<double> all;
    for (const Piece& p : pieces_) all.push_back(p.value.domain().low);
    all.push_back(domain().high);
    return all;
}

Jet PiecewiseChebyshev::over(const Interval& x, int order) const {
    assert(order >= 0 && order <= 2);
    const Piece& p = piece(middle(x));
    return (order == 0 ? p.value : order == 1 ? p.first : p.second).over(x);
}

}  // namespace fusee::math
