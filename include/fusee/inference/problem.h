#pragma once
#include <Eigen/Core>
#include <vector>

#include "fusee/effects/effect.h"
#include "fusee/inference/uncertainty.h"
#include "fusee/joint_model/build_parameters.h"

namespace fusee::inference {

inline constexpr double kEffectPrior = 3.0;  ///< one sigma of an effect's size, in its scale

/// One or two effects, each on its side; none at all for the nominal rig.
using Causes = std::vector<effects::Cause>;

/// A case prepared for fits: x = (build parameters in sigmas, then each cause's parameters in their scales).
/// Residuals are (measured - predicted)/sigma, experiment by experiment, in the order of Signals.
class Problem {
public:
    explicit Problem(const gap_case::Case& gap_case);

    [[nodiscard]] const gap_case::Case& gap_case() const { return gap_case_; }
    [[nodiscard]] const std::vector<joint_model::BuildParameter>& build() const { return build_; }
    [[nodiscard]] const joint_model::NominalCams& cams() const { return cams_; }
    /// The library's effect with the parameters of this rig. @throws core::InvalidInput if the id is unknown
    [[nodiscard]] const effects::Effect& effect(const std::string& id) const;
    [[nodiscard]] const Uncertainty& known() const { return known_; }
    [[nodiscard]] const joint_model::Signals& measured() const { return measured_; }
    [[nodiscard]] int size(const Causes& causes) const;    ///< of x
    [[nodiscard]] int residuals() const { return rows_; }  ///< how many
    [[nodiscard]] gap_case::Experiment experiment_of(int residual) const;
    [[nodiscard]] int size_at(const Causes& causes, std::size_t cause) const;      ///< the place in x of causes[cause]'s size
    [[nodiscard]] core::Range allowed(const Causes& causes, int parameter) const;  ///< of x[parameter]
    /// Start of a fit of these causes: sizes at their first start.
    [[nodiscard]] Eigen::VectorXd start(const Causes& causes) const;
    /// Prior mean of x: 0 for build parameters and sizes, the start value for further parameters.
    [[nodiscard]] Eigen::VectorXd prior_mean(const Causes& causes) const;
    /// `x` of `causes` reduced to the hypothesis with the cause `kept` only.
    [[nodiscard]] Eigen::VectorXd without_others(const Causes& causes, const Eigen::VectorXd& x, const effects::Cause& kept) const;
    [[nodiscard]] double prior_sigma(const Causes& causes, int parameter) const;
    /// The same hypothesis with one of the two ways to write a ripple: its size is positive, its phase within half a turn of 0.
    [[nodiscard]] Eigen::VectorXd with_positive_ripples(const Causes& causes, Eigen::VectorXd x) const;
    enum class Role { kBuild, kSize, kFurther, kCount, kPhase };
    /// What x[parameter] is: a build parameter, the size of an effect, a further parameter of one, or the count or phase of a ripple.
    [[nodiscard]] Role role(const Causes& causes, int parameter) const;

    [[nodiscard]] joint_model::BuiltRig rig(const Causes& causes, const Eigen::VectorXd& x) const;
    [[nodiscard]] joint_model::Signals predict(const Causes& causes, const Eigen::VectorXd& x) const;
    [[nodiscard]] Eigen::VectorXd residual(const joint_model::Signals& prediction) const;
    [[nodiscard]] Eigen::VectorXd residual(const Causes& causes, const Eigen::VectorXd& x) const { return residual(predict(causes, x)); }
    /// The same with one dead-band repeat per level: half the time.
    [[nodiscard]] Eigen::VectorXd thin_residual(const Causes& causes, const Eigen::VectorXd& x) const {
        return residual(predict_thin(causes, x));
    }
    /// The same for break-away and spring pulls, which need no motion; 0 elsewhere.
    [[nodiscard]] Eigen::VectorXd direct_residual(const Causes& causes, const Eigen::VectorXd& x) const;
    /// d residual/dx[parameter], from predictions with one dead-band repeat per level.
    [[nodiscard]] Eigen::VectorXd slope(const Causes& causes, const Eigen::VectorXd& x, int parameter) const;
    /// sqrt(weight) of each residual.
    [[nodiscard]] const Eigen::VectorXd& root_weight() const { return root_weight_; }

private:
    [[nodiscard]] joint_model::Signals predict_thin(const Causes& causes, const Eigen::VectorXd& x) const;

    template <typename Visit>
    void visit_parameters(const Causes& causes, const Visit& visit) const;

    const gap_case::Case& gap_case_;
    std::vector<effects::Effect> library_;  // of this rig
    joint_model::NominalCams cams_;
    std::vector<joint_model::BuildParameter> build_;
    Uncertainty known_;
    joint_model::Signals measured_;
    gap_case::Rows thin_;            // one repeat a level
    std::vector<std::size_t> like_;  // of each dead-band row, its row in thin_
    int rows_ = 0;
    std::array<int, gap_case::kExperiments + 1> first_{};
    Eigen::VectorXd root_weight_;
};

}  // namespace fusee::inference
