#include "fusee/joint_model/cam_spring.h"

#include <cassert>
#include <cmath>
#include <mutex>
#include <utility>

#include "fusee/gap_case/reference.h"
#include "fusee/math/curve.h"

namespace fusee::joint_model {

namespace {

/// Cells of a table. Linear between them: 1e-3 of the greatest torque for the steepest stiction-compensating law.
constexpr std::size_t kCells = 1200;
constexpr std::size_t kRefinement = gap_case::NominalRig::kSpringSteps;  ///< grid of the nominal cams
constexpr double kLeastArm = 1e-5;   ///< least arm, on the reference rig [m]: a fit that tries a shorter one sees a very stiff spring
constexpr double kStepWidth = 0.02;  ///< of the cam's end
constexpr std::size_t kRecent = 16;  ///< springs that are kept: of the four rigs that are predicted together
constexpr double kLeastTurn = 1e-9;  ///< [rad], least step of a table, which must rise

}  // namespace

double SpringBuild::arm_factor(double share) const {
    if (step == 0.0) return 1.0;
    const double in = std::clamp((share - step_at) / kStepWidth + 0.5, 0.0, 1.0);
    return 1.0 + step * in * in * (3.0 - 2.0 * in);
}

CamSpring::CamSpring(const std::vector<double>& x, const std::vector<double>& torque, double stiffness)
    : torque_(kCells + 1), per_step_(kCells / x.back()), last_(kCells) {
    assert(x.size() >= 2 && x.size() == torque.size() && x.back() > 0.0 && std::isfinite(x.back()));
    std::size_t row = 0;
    for (std::size_t i = 0; i <= kCells; ++i) {
        const double place = x.back() * static_cast<double>(i) / kCells;
        while (row + 2 < x.size() && x[row + 1] < place) ++row;
        const double share = (place - x[row]) / (x[row + 1] - x[row]);
        torque_[i] = std::max(0.0, torque[row] + share * (torque[row + 1] - torque[row]));
    }
    torque_.push_back(torque_.back() + stiffness / per_step_);
}

double CamSpring::deflection(double torque) const {
    const auto above = std::upper_bound(torque_.begin(), torque_.end(), torque);
    if (above == torque_.begin()) return 0.0;
    const auto i = std::min<std::size_t>(above - torque_.begin() - 1, torque_.size() - 2);
    const double rise = torque_[i + 1] - torque_[i];
    return (static_cast<double>(i) + (rise > 0.0 ? (torque - torque_[i]) / rise : 0.0)) / per_step_;
}

/// Threads share it.
class NominalCams::Recent {
public:
    template <class Make>
    [[nodiscard]] CamSpring of(bool series, const SpringBuild& build, const Make& make) {
        {
            const std::lock_guard lock(mutex_);
            for (const Entry& entry : entries_)
                if (entry.series == series && entry.build == build) return entry.spring;
        }
        Entry made{series, build, make()};
        const std::lock_guard lock(mutex_);
        if (entries_.size() < kRecent) return entries_.emplace_back(std::move(made)).spring;
        return (entries_[next_++ % kRecent] = std::move(made)).spring;
    }

private:
    struct Entry {
        bool series;
        SpringBuild build;
        CamSpring spring;
    };
    std::mutex mutex_;
    std::vector<Entry> entries_;
    std::size_t next_ = 0;
};

NominalCams::NominalCams(const gap_case::NominalRig& rig)
    : recent_(std::make_shared<Recent>()),
      capstan_radius_(rig.capstan_radius),
      least_arm_(kLeastArm * gap_case::reference_of(rig).radius),
      k_se_(rig.se_torsion_rate),
      k_pe_(rig.pe_compression_rate) {
    std::vector<double> x, se, pe;
    for (const gap_case::NominalRig::SpringRow& row : rig.springs) {
        x.push_back(row.deflection);
        se.push_back(row.se_torque);
        pe.push_back(row.pe_torque);
    }
    rig.require_rising_springs();
    const math::CurvePtr se_curve = math::make_interpolant(x, se), pe_curve = math::make_interpolant(x, pe);
    double u_se = 0.0, u_pe = 0.0, last_se = 0.0, last_pe = 0.0;
    for (std::size_t i = 0; i <= kRefinement; ++i) {
        const double place = x.back() * static_cast<double>(i) / kRefinement, step = x.back() / kRefinement;
        const double f_se = se_curve->value(place), f_pe = pe_curve->value(place);
        if (i > 0) {  // Simpson's rule over the step
            u_se += step / 6.0 * (last_se + 4.0 * se_curve->value(place - 0.5 * step) + f_se);
            u_pe += step / 6.0 * (last_pe + 4.0 * pe_curve->value(place - 0.5 * step) + f_pe);
        }
        last_se = f_se;
        last_pe = f_pe;
        x_.push_back(place);
        phi_.push_back(std::sqrt(2.0 * u_se / k_se_));
        y_.push_back(std::sqrt(2.0 * u_pe / k_pe_));
        se_arm_.push_back(i == 0 ? 0.0 : capstan_radius_ * k_se_ * phi_.back() / f_se);
        pe_arm_.push_back(i == 0 ? 0.0 : f_pe / (k_pe_ * y_.back()));
    }
    // At deflection 0 both are 0/0: straight on from the next two.
    se_arm_[0] = 2.0 * se_arm_[1] - se_arm_[2];
    pe_arm_[0] = 2.0 * pe_arm_[1] - pe_arm_[2];
}

CamSpring NominalCams::series(const SpringBuild& build) const {
    return recent_->of(true, build, [&] { return make_series(build); });
}

CamSpring NominalCams::parallel(const SpringBuild& build) const {
    return recent_->of(false, build, [&] { return make_parallel(build); });
}

CamSpring NominalCams::make_series(const SpringBuild& build) const {
    std::vector<double> x(x_.size()), torque(x_.size());
    double arm = 0.0, gained = 0.0;  // cable that the step gains [m]
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const double whole = se_arm_[i] + build.radius, factor = build.arm_factor(phi_[i] / phi_.back());
        if (i > 0) gained += whole * (factor - 1.0) * (phi_[i] - phi_[i - 1]);
        arm = std::max(least_arm_, whole * factor);
        torque[i] = std::max(0.0, capstan_radius_ * k_se_ * (1.0 + build.rate) * (phi_[i] + build.preload) / arm);
        x[i] = x_[i] + (build.radius * phi_[i] + gained) / capstan_radius_ + build.stretch * torque[i];
        if (i > 0) x[i] = std::max(x[i], x[i - 1] + kLeastTurn);
    }
    const double lever = capstan_radius_ / arm;
    const double stiffness = k_se_ * (1.0 + build.rate) * lever * lever;
    return {x, torque, stiffness / (1.0 + stiffness * build.stretch)};
}

double NominalCams::shortest_series_arm() const { return *std::min_element(se_arm_.begin(), se_arm_.end()); }

CamSpring NominalCams::make_parallel(const SpringBuild& build) const {
    std::vector<double> torque(x_.size());
    double arm = 0.0, gained = 0.0;  // compression that the step gains [m]
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const double whole = pe_arm_[i] + build.radius, factor = build.arm_factor(x_[i] / x_.back());
        if (i > 0) gained += whole * (factor - 1.0) * (x_[i] - x_[i - 1]);
        arm = whole * factor;
        const double y = y_[i] + build.radius * x_[i] + gained;
        const double force = std::max(0.0, y + build.preload) + build.binding_rate * std::max(0.0, y - build.binds_at);
        torque[i] = k_pe_ * (1.0 + build.rate) * force * arm;
    }
    const double rate = k_pe_ * (1.0 + build.rate) * (y_.back() > build.binds_at ? 1.0 + build.binding_rate : 1.0);
    return {x_, torque, rate * arm * arm};
}

}  // namespace fusee::joint_model
