#include "starts.h"

#include <algorithm>
#include <cmath>

#include "descend.h"
#include "fusee/core/units.h"
#include "fusee/inference/constants.h"
#include "fusee/inference/screen.h"

namespace fusee::inference {

namespace {

using Starts = std::vector<Eigen::VectorXd>;

/// Every start of the size with every try of the further parameters.
Starts grid_of(const Effect& effect, Eigen::Index size_at, Eigen::VectorXd first) {
    Starts all;
    for (const double size : effect.starts) {
        first[size_at] = size;
        all.push_back(first);
    }
    for (std::size_t k = 1; k < effect.parameters.size(); ++k) {
        const EffectParameter& p = effect.parameters[k];
        if (p.tries.empty()) continue;
        Starts more;
        for (const Eigen::VectorXd& x : all)
            for (const double value : p.tries) {
                more.push_back(x);
                more.back()[size_at + static_cast<Eigen::Index>(k)] = value / p.scale;
            }
        all = std::move(more);
    }
    return all;
}

/// Ripples upon a fit. A ripple acts nearly in proportion to its amplitude, so that of each count two predictions are enough: its sine
/// and its cosine.
class RippleScan {
public:
    RippleScan(const Problem& problem, const Fit& base, const Causes& causes, const std::vector<bool>* kept)
        : problem_(problem), base_(base), causes_(causes), kept_(kept), effect_(problem.effect(causes.back().id)), size_at_(base.x.size()) {
        held_ = base.spread.cwiseInverse().asDiagonal() * base.jacobian;
        residual_ = problem.thin_residual(base.causes, base.x).cwiseQuotient(base.spread);
    }
    /// The counts that fit best in the linear model, with amplitude and phase. `first`: x with anything at the place of the ripple.
    [[nodiscard]] Starts best(const Eigen::VectorXd& first) const {
        const EffectParameter& counts = effect_.parameters[1];
        std::vector<Eigen::VectorXd> places;  // of each count the sine and the cosine, at the first start of the size
        for (const double count : counts.tries)
            for (const double phase : {0.0, 0.5 * core::kPi}) {
                places.push_back(first);
                places.back().segment(size_at_, 3) << effect_.starts.front(), count / counts.scale, phase / effect_.parameters[2].scale;
            }
        const std::vector<Eigen::VectorXd> seen = problem_.thin_residuals(causes_, places);
        std::vector<Guess> guesses;
        for (std::size_t i = 0; i < seen.size(); i += 2) guesses.push_back(at(places[i], column(seen[i]), column(seen[i + 1])));
        std::stable_sort(guesses.begin(), guesses.end(), [](const Guess& a, const Guess& b) { return a.cost < b.cost; });
        Starts starts;
        for (std::size_t i = 0; i < std::min(kRippleStarts, guesses.size()); ++i) starts.push_back(guesses[i].x);
        return starts;
    }

private:
    /// d residual/d amplitude, from what the first start of the size leaves.
    [[nodiscard]] Eigen::VectorXd column(const Eigen::VectorXd& seen) const {
        return (seen.cwiseQuotient(base_.spread) - residual_) / effect_.starts.front();
    }
    /// Amplitude and phase at the count of x, in the linear model.
    [[nodiscard]] Guess at(Eigen::VectorXd x, const Eigen::VectorXd& of_sine, const Eigen::VectorXd& of_cosine) const {
        const double count = x[size_at_ + 1];
        Eigen::MatrixXd own = Eigen::MatrixXd::Zero(residual_.size(), 3);  // the amplitude of the cosine in the place of the phase
        own.col(0) = of_sine;
        own.col(2) = of_cosine;
        x[size_at_] = x[size_at_ + 2] = 0.0;
        const Eigen::MatrixXd jacobian = joined(held_, own);
        const Eigen::VectorXd next = linear_step(problem_, causes_, x, residual_, jacobian, kept_);
        const double sine = next[size_at_], cosine = next[size_at_ + 2];
        Guess guess{causes_, next, 1e300};
        guess.x[size_at_] = std::hypot(sine, cosine);
        guess.x[size_at_ + 1] = count;
        guess.x[size_at_ + 2] = std::atan2(cosine, sine) / effect_.parameters[2].scale;
        const double cost = cost_of(problem_, causes_, residual_ + jacobian * (next - x), guess.x, kept_);
        if (std::isfinite(cost)) guess.cost = cost;
        guess.x.head(size_at_) = base_.x;
        return guess;
    }
    const Problem& problem_;
    const Fit& base_;
    const Causes& causes_;
    const std::vector<bool>* kept_;
    const Effect& effect_;
    Eigen::Index size_at_;
    Eigen::MatrixXd held_;
    Eigen::VectorXd residual_;
};

void add_like_the_other_side(const Problem& problem, const Fit& base, const Causes& causes, Starts& starts) {
    const Eigen::Index own = starts.front().size() - base.x.size();
    for (std::size_t c = 0; c < base.causes.size(); ++c) {
        if (base.causes[c].id != causes.back().id) continue;
        starts.push_back(starts.front());
        starts.back().tail(own) = base.x.segment(problem.effect_size_index(base.causes, c), own);
    }
}

/// The same starts with deviating build parameters back at 0: the effect replaces them now. Stick-slip friction
/// gives a fit no slope in that direction.
void add_relaxed(const Problem& problem, Starts& starts) {
    const auto build = static_cast<Eigen::Index>(problem.build().size());
    Eigen::ArrayXd free = starts.front().head(build).array();
    free = (free.abs() > kStrained).select(0.0, free);
    if ((free == starts.front().head(build).array()).all()) return;
    for (std::size_t i = 0, n = starts.size(); i < n; ++i) {
        starts.push_back(starts[i]);
        starts.back().head(build) = free;
    }
}

}  // namespace

std::vector<Eigen::VectorXd> starts_upon(const Problem& problem, const Fit& base, const Causes& causes, const std::vector<bool>* kept) {
    const Effect& effect = problem.effect(causes.back().id);
    Eigen::VectorXd first = problem.start(causes);
    first.head(base.x.size()) = base.x;
    Starts starts =
        effect.has_phase() ? RippleScan(problem, base, causes, kept).best(first) : grid_of(effect, base.x.size(), std::move(first));
    add_like_the_other_side(problem, base, causes, starts);
    add_relaxed(problem, starts);
    return starts;
}

}  // namespace fusee::inference
