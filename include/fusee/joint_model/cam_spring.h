#pragma once
#include <algorithm>
#include <memory>
#include <vector>

#include "fusee/core/units.h"
#include "fusee/gap_case/case.h"

namespace fusee::joint_model {

/// Deviations of a built spring from its nominal cam and base spring.
struct SpringBuild {
    double rate = 0.0;           ///< relative change of the base spring's rate
    double radius = 0.0;         ///< added to every arm [m]
    double preload = 0.0;        ///< base spring wound (+) or slack (-) at deflection 0 [rad of spool] or [m]
    double step = 0.0;           ///< every arm is (1 + step) times from one place of the cam on: a crack or a dent
    double step_at = 1.0;        ///< that place, of the cam's end: turn of the spool (K_SE) or of the capstan (K_PE)
    double stretch = 0.0;        ///< compliance in series [rad/Nm] at the capstan
    double binds_at = 1e9;       ///< compression past which the coils bind [m]; K_PE only
    double binding_rate = 15.0;  ///< rate of bound coils, of the spring's own
    double hysteresis = 0.0;     ///< a of F (1 + a z)
    /// Factor of the arm at `share` of the cam's end; a step takes 0.02 of it.
    [[nodiscard]] double arm_factor(double share) const;
    bool operator==(const SpringBuild&) const = default;
};

/// One spring of a rig with its cam and cable: torque over deflection at the capstan, tabulated uniformly, so that one evaluation costs a
/// few nanoseconds. A cable cannot push: 0 below deflection 0. Beyond the drawn end of the cam its arm stays that of the end, so that the
/// torque continues linearly with the rate of the base spring at that arm.
class CamSpring {
public:
    CamSpring() = default;
    /// @param stiffness beyond the end [Nm/rad]
    /// @pre x rises to an end above 0; all finite
    CamSpring(const std::vector<double>& x, const std::vector<double>& torque, double stiffness);

    [[nodiscard]] double torque(double x) const {
        if (x <= 0.0) return x <= -kStop ? 0.0 : torque_[0] * (1.0 + x / kStop);
        const double place = x * per_step_;
        const auto i = place < last_ ? static_cast<std::size_t>(place) : static_cast<std::size_t>(last_);
        return torque_[i] + (place - static_cast<double>(i)) * (torque_[i + 1] - torque_[i]);
    }
    /// Least deflection that gives `torque`; below the first: 0.
    [[nodiscard]] double deflection(double torque) const;
    [[nodiscard]] double end() const { return last_ / per_step_; }  ///< of the drawn cam [rad]
    // The table itself, for several springs at once (rig_lanes.h).
    [[nodiscard]] const double* cells() const { return torque_.data(); }  ///< torque at the ends of the cells [Nm]
    [[nodiscard]] double cells_per_rad() const { return per_step_; }      ///< [1/rad]
    [[nodiscard]] double last_cell() const { return last_; }              ///< the cell beyond the drawn cam
    static constexpr double kStop = 0.01;                                 ///< travel in which a preloaded cable goes slack [rad]
    /// The same with the torque times `factor` of the share of the end, 0 to 1.
    template <class Factor>
    [[nodiscard]] CamSpring scaled(const Factor& factor) const {
        CamSpring other = *this;
        for (std::size_t i = 0; i < torque_.size(); ++i) other.torque_[i] *= factor(std::min(1.0, static_cast<double>(i) / last_));
        return other;
    }

private:
    std::vector<double> torque_{0.0, 0.0};  // at the ends of the cells; the last one, at last_, lies beyond the drawn cam
    double per_step_ = 1.0, last_ = 0.0;
};

/// The nominal cams of a rig, from its spring curves (docs/theory/diagnosis.md, eq. 5 and 6): spool angle phi with k_t phi^2/2 = U_SE and
/// arm r = r_c k_t phi/F_SE; compression y with k y^2/2 = U_PE and arm r = F_PE/(k y).
class NominalCams {
public:
    /// @throws core::InvalidInput if a curve does not rise
    explicit NominalCams(const gap_case::NominalRig& rig);
    /// Exact: x = x0 + dr phi/r_c, F = r_c k (phi + phi0)/(r + dr) (docs/theory/springs.md, eq. 24 to 27). Where r + dr is not a valid arm
    /// of a spool, 0.01 mm (of the reference rig) replaces it, so that a fit may try any dr.
    [[nodiscard]] CamSpring series(const SpringBuild& build) const;
    /// y = y0 + dr x, F = k (y + preload)(r + dr).
    [[nodiscard]] CamSpring parallel(const SpringBuild& build) const;
    [[nodiscard]] double greatest_compression() const { return y_.back(); }  ///< of the nominal K_PE [m]
    [[nodiscard]] double end() const { return x_.back(); }                   ///< of both curves [rad]
    [[nodiscard]] double shortest_series_arm() const;                        ///< of the nominal spool [m]

private:
    class Recent;
    [[nodiscard]] CamSpring make_series(const SpringBuild& build) const;
    [[nodiscard]] CamSpring make_parallel(const SpringBuild& build) const;

    std::shared_ptr<Recent> recent_;  ///< springs that were asked for: predictions of a fit differ in one of four, or in none
    double capstan_radius_, least_arm_, k_se_, k_pe_;
    std::vector<double> x_, phi_, y_, se_arm_, pe_arm_;
};

}  // namespace fusee::joint_model
