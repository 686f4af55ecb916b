#pragma once
#include <Eigen/Core>
#include <vector>

#include "fusee/inference/constants.h"
#include "fusee/inference/model.h"

namespace fusee::inference {

/// Effects, each on its side; none at all for the nominal model.
using Causes = std::vector<Cause>;

/// d residual/dx of the first parameters of x, which a fit keeps on its way as long as they hold (Problem::slopes_hold).
struct HeldSlopes {
    Eigen::MatrixXd slopes;
    Eigen::VectorXd at;  ///< where they were taken
};

/// A model prepared for fits: x = (build parameters in sigmas, then each cause's parameters in their scales).
/// Residuals are (measured - predicted)/sigma, experiment by experiment, in the order of Model::experiments.
class Problem {
public:
    /// @pre the model outlives it
    /// @param width of the prior of each build parameter [its sigma]: 1 as stated, kPlainWidth for a fit that hardly asks for tolerances
    explicit Problem(const Model& model, double width = 1.0);

    [[nodiscard]] const Model& model() const { return model_; }
    [[nodiscard]] const std::vector<BuildParameter>& build() const { return model_.build(); }
    [[nodiscard]] const std::vector<Experiment>& experiments() const { return model_.experiments(); }
    /// @throws core::InvalidInput if the id is unknown
    [[nodiscard]] const Effect& effect(const std::string& id) const;
    /// Are there causes by the name of a build parameter? Then a fit that lacks the right one may be far from what was stated, where no
    /// slope holds on the way back.
    [[nodiscard]] bool has_figures() const { return has_figures_; }
    /// Sizes below it are no effect, in usual sizes: what a law leaves open.
    [[nodiscard]] double least_size(const Effect& effect) const { return model_.knows_usual_sizes() ? kLeastSize : effect.least; }
    /// Do slopes by the first parameters of x that were taken at `at` hold at x? Where there are figures only near it.
    [[nodiscard]] bool slopes_hold(const Eigen::VectorXd& at, const Eigen::VectorXd& x) const {
        return !has_figures_ || at.size() == 0 || (x.head(at.size()) - at).cwiseAbs().maxCoeff() <= kHeldReach;
    }
    /// Is x so near to `at` that slopes from there are those at x? They are differences over steps, which no parameter is beyond. False
    /// if there is no `at`.
    [[nodiscard]] bool slopes_hold_between(const Causes& causes, const Eigen::VectorXd& at, const Eigen::VectorXd& x) const;
    [[nodiscard]] int dimension(const Causes& causes) const;  ///< of x
    [[nodiscard]] int residual_count() const { return rows_; }
    /// The place in `experiments` of the experiment that a residual belongs to.
    [[nodiscard]] std::size_t experiment_of(int residual) const { return experiment_of_[static_cast<std::size_t>(residual)]; }
    [[nodiscard]] int effect_size_index(const Causes& causes, std::size_t cause) const;  ///< the place in x of causes[cause]'s size
    [[nodiscard]] core::Range allowed(const Causes& causes, int parameter) const;        ///< of x[parameter]
    /// Start of a fit of these causes: sizes at their first start.
    [[nodiscard]] Eigen::VectorXd start(const Causes& causes) const;
    /// x of the model before any effect: its nominal figures, and those that nobody states as `null` found them.
    [[nodiscard]] Eigen::VectorXd as_stated(const Eigen::VectorXd& null) const;
    /// Prior mean of x: 0 for build parameters and sizes, the start value for further parameters.
    [[nodiscard]] Eigen::VectorXd prior_mean(const Causes& causes) const;
    /// `x` of `causes` without the parameters of causes[cause].
    [[nodiscard]] Eigen::VectorXd without(const Causes& causes, const Eigen::VectorXd& x, std::size_t cause) const;
    [[nodiscard]] double prior_sigma(const Causes& causes, int parameter) const;
    /// The same hypothesis with one of the two ways to write a ripple: its size is positive, its phase within half a turn of 0.
    [[nodiscard]] Eigen::VectorXd with_positive_ripples(const Causes& causes, Eigen::VectorXd x) const;
    enum class Role { kBuild, kSize, kFurther, kCount, kPhase };
    /// What x[parameter] is: a build parameter, the size of an effect, a further parameter of one, or the count or phase of a ripple.
    [[nodiscard]] Role role(const Causes& causes, int parameter) const;

    /// The model's setting at x, within the limits of the effects' parameters.
    [[nodiscard]] Setting setting(const Causes& causes, const Eigen::VectorXd& x) const;
    /// NaN where the model refuses.
    [[nodiscard]] Outputs predict(const Causes& causes, const Eigen::VectorXd& x, Extent extent = Extent::kAll) const;
    [[nodiscard]] std::vector<Outputs> predict_each(const Causes& causes, const std::vector<Eigen::VectorXd>& places, Extent extent) const;
    [[nodiscard]] Eigen::VectorXd residual(const Outputs& prediction) const;
    [[nodiscard]] Eigen::VectorXd residual(const Causes& causes, const Eigen::VectorXd& x) const { return residual(predict(causes, x)); }
    /// The same with one prediction for the repeats of a set point (Extent::kOncePerSetPoint).
    [[nodiscard]] Eigen::VectorXd thin_residual(const Causes& causes, const Eigen::VectorXd& x) const {
        return residual(predict(causes, x, Extent::kOncePerSetPoint));
    }
    /// The same at several places, four at a time, which may cost less together (Model::predict_each).
    [[nodiscard]] std::vector<Eigen::VectorXd> thin_residuals(const Causes& causes, const std::vector<Eigen::VectorXd>& places,
                                                              unsigned jobs = 1) const;
    /// The same for experiments with Experiment::direct; 0 elsewhere.
    [[nodiscard]] Eigen::VectorXd direct_residual(const Causes& causes, const Eigen::VectorXd& x) const;
    /// d residual/dx of the parameters `first` up to `last`, a column each, from thin residuals.
    /// @param here if not null, the thin residual at x is put there; together they cost less
    [[nodiscard]] Eigen::MatrixXd slopes(const Causes& causes, const Eigen::VectorXd& x, Eigen::Index first, Eigen::Index last,
                                         unsigned jobs = 1, Eigen::VectorXd* here = nullptr) const;
    /// `held` as it is at x: taken anew, by differences to one side, if it does not hold there.
    void renew(HeldSlopes& held, const Causes& causes, const Eigen::VectorXd& x, unsigned jobs = 1) const;
    /// sqrt(weight) of each residual.
    [[nodiscard]] const Eigen::VectorXd& root_weight() const { return root_weight_; }

private:
    template <typename Visit>
    void visit_parameters(const Causes& causes, const Visit& visit) const;
    [[nodiscard]] double step_of(const Causes& causes, int parameter) const;  ///< of a difference

    const Model& model_;
    double width_ = 1.0;
    int rows_ = 0;
    bool has_figures_ = false;
    std::vector<std::size_t> experiment_of_;
    Eigen::VectorXd root_weight_;
};

}  // namespace fusee::inference
