#include "isolability.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "fusee/core/parallel.h"
#include "fusee/inference/search.h"
#include "power.h"

namespace fusee::diagnosis {

namespace {

/// What a cause changes and the fit cannot follow. Priors count as rows of their own, on which no cause leaves a mark: so the least-squares
/// projection of (change, 0) has the length that the evidence sees, s^T (I - J (J^T J + prior)^-1 J^T) s.
class Projection {
public:
    Projection(const inference::Problem& problem, const inference::Fit& null) : problem_(problem), null_(null) {
        weight_ = problem.root_weight().cwiseQuotient(null.spread);  // without the loss: a great gap must not cut its own cause's mark
        residual_ = problem.thin_residual(null.causes, null.x);
        const auto rows = null.jacobian.rows(), columns = null.jacobian.cols();
        followed_.resize(rows + columns, columns);
        followed_.topRows(rows) = weight_.asDiagonal() * null.jacobian;
        followed_.bottomRows(columns).setZero();
        for (int k = 0; k < columns; ++k) followed_(rows + k, k) = 1.0 / problem.prior_sigma(null.causes, k);
        normal_.compute(followed_.transpose() * followed_);
    }
    /// The mark of the last of `causes` at `size` scales, the rest as in the null fit.
    [[nodiscard]] Eigen::VectorXd mark(const inference::Causes& causes, double size) const {
        Eigen::VectorXd x = problem_.start(causes), change = Eigen::VectorXd::Zero(followed_.rows());
        x.head(null_.x.size()) = null_.x;
        x[null_.x.size()] = size;
        change.head(weight_.size()) = weight_.cwiseProduct(problem_.thin_residual(causes, x) - residual_);
        return change - followed_ * normal_.solve(followed_.transpose() * change);
    }

private:
    const inference::Problem& problem_;
    const inference::Fit& null_;
    Eigen::VectorXd weight_, residual_;
    Eigen::MatrixXd followed_;
    Eigen::LLT<Eigen::MatrixXd> normal_;
};

/// A cause at its usual size.
struct Mark {
    Eigen::VectorXd change;  ///< in sigmas
    double length = 0.0;
    bool both_ways = false;         ///< its size may have either sign
    double detectable = kNoFigure;  ///< in the parameter's unit
    double named = kNoFigure;       ///< the same
};

/// 0 is no effect of most parameters; a limit never is 0, and does the more the smaller it is.
bool is_limit(const inference::EffectParameter& size) { return size.allowed.low > 0.0; }

double nearest_to_one(const std::vector<double>& starts) {
    return *std::min_element(starts.begin(), starts.end(), [](double a, double b) { return std::abs(a - 1.0) < std::abs(b - 1.0); });
}

/// @param smallest size that is an effect, in scales
Mark mark_of_size(const Projection& projection, const inference::Causes& causes, const inference::Effect& effect, double smallest) {
    const inference::EffectParameter& size = effect.parameters.front();
    const double tried = nearest_to_one(effect.starts);
    Mark mark;
    mark.change = projection.mark(causes, tried) / tried;
    mark.length = mark.change.norm();
    mark.both_ways = size.allowed.low < 0.0;
    const double least = inference::kSeen * size.scale / mark.length;
    const double most = std::max(-size.allowed.low, size.allowed.high);
    if (least <= most) mark.detectable = least;
    if (!(mark.length > inference::kNothing)) return mark;
    const double named = size.scale * std::max(smallest, named_length(mark.length) / mark.length);
    if (named <= most) mark.named = named;
    return mark;
}

/// The greatest size of a limit of which `enough` of a mark is left, to 2 % of its logarithm. @param seen one that has enough
template <typename Enough>
double greatest(const Projection& projection, const inference::Causes& causes, const inference::EffectParameter& size, double seen,
                const Enough& enough) {
    double unseen = size.allowed.high / size.scale;
    for (int i = 0; i < inference::kHalvings; ++i) {
        const double middle = std::sqrt(seen * unseen);
        (enough(projection.mark(causes, middle).norm()) ? seen : unseen) = middle;
    }
    return seen * size.scale;
}

/// The mark at the start that is nearest to one scale among those that are seen, or at the strictest.
Mark mark_of_limit(const Projection& projection, const inference::Causes& causes, const inference::Effect& effect) {
    const inference::EffectParameter& size = effect.parameters.front();
    std::vector<double> starts = effect.starts;
    std::sort(starts.begin(), starts.end(), std::greater<>());
    starts.erase(starts.begin(), std::find(starts.begin(), starts.end(), nearest_to_one(starts)));
    const auto seen = [](double length) { return length >= inference::kSeen; };
    const auto named = [](double length) { return length > inference::kNothing && length >= named_length(length); };
    Mark mark;
    for (const double start : starts) {  // the loosest first
        Eigen::VectorXd change = projection.mark(causes, start);
        const double length = change.norm();
        if (!seen(mark.length)) {
            mark.change = std::move(change);
            mark.length = length;
            if (seen(length)) mark.detectable = greatest(projection, causes, size, start, seen);
        }
        if (!named(length)) continue;
        mark.named = greatest(projection, causes, size, start, named);
        break;
    }
    return mark;
}

/// Could one pass for the other? `cosine` is that of their marks.
bool cannot_tell(const Mark& a, const Mark& b, double cosine) {
    const double least = std::min(a.length, b.length);
    if (least < inference::kSeen || std::abs(cosine) < inference::kSimilar) return false;
    if (cosine < 0.0 && !a.both_ways && !b.both_ways) return false;
    return least * std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) < inference::kSeen;
}

/// Connected components of two or more, in the order of their first members.
std::vector<std::vector<std::size_t>> components(const std::vector<std::vector<bool>>& linked) {
    std::vector<std::size_t> name(linked.size());
    std::iota(name.begin(), name.end(), std::size_t{0});
    for (std::size_t i = 0; i < linked.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (linked[i][j]) std::replace(name.begin(), name.end(), std::max(name[i], name[j]), std::min(name[i], name[j]));
    std::vector<std::vector<std::size_t>> classes(linked.size());
    for (std::size_t i = 0; i < linked.size(); ++i) classes[name[i]].push_back(i);
    std::erase_if(classes, [](const auto& members) { return members.size() < 2; });
    return classes;
}

}  // namespace

Isolability isolability(const inference::Problem& problem, const inference::Fit& null, const std::vector<inference::Cause>& causes,
                        unsigned jobs) {
    const Projection projection(problem, null);
    const std::size_t n = causes.size();
    std::vector<Mark> marks(n);
    core::parallel_for(n, jobs, [&](std::size_t i) {
        inference::Causes all = null.causes;
        all.push_back(causes[i]);
        const inference::Effect& effect = problem.effect(causes[i].id);
        marks[i] = is_limit(effect.parameters.front()) ? mark_of_limit(projection, all, effect)
                                                       : mark_of_size(projection, all, effect, problem.least_size(effect));
    });
    Isolability result{causes, std::vector(n, std::vector<double>(n, 0.0)), {}, {}, {}, {}};
    std::vector<std::vector<bool>> linked(n, std::vector<bool>(n, false));
    for (std::size_t i = 0; i < n; ++i) {
        result.detectable.push_back(marks[i].detectable);
        result.named.push_back(marks[i].named);
        result.units.push_back(problem.effect(causes[i].id).parameters.front().unit);
        result.signature_similarity[i][i] = 1.0;
        for (std::size_t j = 0; j < i; ++j) {
            const double lengths = marks[i].length * marks[j].length;
            const double cosine =
                lengths > inference::kNothing ? std::clamp(marks[i].change.dot(marks[j].change) / lengths, -1.0, 1.0) : 0.0;
            result.signature_similarity[i][j] = result.signature_similarity[j][i] = std::abs(cosine);
            linked[i][j] = cannot_tell(marks[i], marks[j], cosine);
        }
    }
    result.classes = components(linked);
    return result;
}

}  // namespace fusee::diagnosis
