#include "fusee/actuator/relatives.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "fusee/actuator/equilibrium.h"
#include "fusee/core/error.h"
#include "fusee/spring/potential.h"

// Equation numbers: docs/theory/relatives.md.
namespace fusee::actuator {

namespace {

/// A spring that pulls and pushes: odd in its deflection. A preload changes sign along a straight line through 0.
class BothWays final : public spring::Potential {
public:
    explicit BothWays(spring::PotentialPtr spring)
        : one_way_(spring::behind_cable(std::move(spring))), zero_(one_way_->domain().low), turn_(one_way_->force(zero_ + kTurn) / kTurn) {}

    [[nodiscard]] core::Range domain() const override {
        const double reach = one_way_->domain().width();
        return {-reach, reach};
    }
    [[nodiscard]] double energy(double x) const override {
        if (std::abs(x) < kTurn) return one_way_->energy(zero_ + kTurn) - 0.5 * turn_ * (kTurn * kTurn - x * x);
        return one_way_->energy(zero_ + std::abs(x));
    }
    [[nodiscard]] double force(double x) const override {
        return std::abs(x) < kTurn ? turn_ * x : std::copysign(one_way_->force(zero_ + std::abs(x)), x);
    }
    [[nodiscard]] double stiffness(double x) const override {
        return std::abs(x) < kTurn ? turn_ : one_way_->stiffness(zero_ + std::abs(x));
    }
    [[nodiscard]] double slope(double x) const override {
        return std::abs(x) < kTurn ? 0.0 : std::copysign(one_way_->slope(zero_ + std::abs(x)), x);
    }

private:
    static constexpr double kTurn = 1e-4;  ///< [rad], as a cable's stop
    spring::PotentialPtr one_way_;
    double zero_, turn_;
};

void require_spring(const char* field, const spring::PotentialPtr& spring) {
    if (!spring) throw core::InvalidInput(field, "none", "a spring");
}

void validate(const ArrangementOptions& options) {
    require_spring("series", options.series);
    if (options.arrangement == Arrangement::kPnrvsa) require_spring("parallel", options.parallel);
    core::require_positive("capstan_radius", options.capstan_radius, "m");
    core::require_positive("joint_radius", options.joint_radius, "m");
    constexpr double kLargest = std::numeric_limits<double>::max();
    core::require_within("position_stiffness", options.position_stiffness, 0.0, kLargest, "Nm/rad");
    core::require_within("cross_stretch", options.cross_stretch, -kLargest, kLargest, "rad");
}

/// The networks of docs/theory/relatives.md; the agonist's series spring is first, except in the paper's joint.
std::vector<JointSpring> springs_of(const ArrangementOptions& options, double g) {
    const auto cable = [](const spring::PotentialPtr& s) { return spring::behind_cable(s); };
    const auto both_ways = [](const spring::PotentialPtr& s) { return std::make_shared<BothWays>(s); };
    const Eigen::Vector3d agonist(1.0, 0.0, g), antagonist(0.0, 1.0, -g);
    switch (options.arrangement) {
        case Arrangement::kSeriesElastic:
            return {{"K_SE", both_ways(options.series), agonist}};
        case Arrangement::kQuasiAntagonist:
            return {{"spring on the drive", cable(options.series), agonist},
                    {"spring on the stiffness motor", cable(options.series), {-1.0, 1.0, -g}}};
        case Arrangement::kBidirectional:
            return {{"springs of motor 1", both_ways(options.series), agonist},
                    {"springs of motor 2", both_ways(options.series), antagonist}};
        default:
            break;
    }
    std::vector<JointSpring> springs{{"K_SE agonist", cable(options.series), agonist},
                                     {"K_SE antagonist", cable(options.series), antagonist}};
    if (options.arrangement == Arrangement::kCrossCoupled && options.parallel)
        springs.push_back({"cross spring", cable(options.parallel), {-1.0, -1.0, 0.0}, options.cross_stretch});
    return springs;
}

/// Motor torques at one level; the held output carries the difference.
Eigen::Vector3d torques_at(Arrangement arrangement, double level) {
    switch (arrangement) {
        case Arrangement::kSeriesElastic:
            return {level, 0.0, 0.0};
        case Arrangement::kQuasiAntagonist:
            return {0.0, level, 0.0};
        default:
            return {level, level, 0.0};
    }
}

/// One level of co-contraction.
struct Level {
    double series_torque = 0.0;  ///< of the agonist's series spring [Nm]
    double held = 0.0;           ///< eq. 2 [Nm/rad]
    double free = 0.0;           ///< eq. 3 [Nm/rad]
    double dead_band = 0.0;      ///< eq. 4 [rad]
};

/// The networks at rest at q = 0, where no loop is needed to hold them; loops act only on deviations from it.
class Survey {
public:
    explicit Survey(const ArrangementOptions& options) : arrangement_(options.arrangement), joint_(make_arrangement(options)) {
        ArrangementOptions passive = options;
        passive.position_stiffness = 0.0;
        held_ = make_arrangement(passive);
        held_.frozen[kOutput] = true;
        for (const int body : {kAgonist, kAntagonist})
            if (!joint_.frozen[static_cast<std::size_t>(body)]) motors_.push_back(body);
    }

    /// @throws InvalidInput if a spring leaves its law
    [[nodiscard]] Level at(double level) const {
        const auto rest = find_equilibrium(held_, torques_at(arrangement_, level));
        if (!rest) throw core::InvalidInput("cocontraction", fmt::format("{:g} Nm", level), core::to_line(rest.refusal().front()));
        Level result;
        result.series_torque = series_torque(rest->z);
        const Eigen::Matrix3d k = stiffness(joint_, rest->z);
        const Eigen::VectorXd coupling = k.col(kOutput)(motors_);
        const Eigen::VectorXd follow = k(motors_, motors_).inverse() * coupling;  // motion of the motors per -q under constant torque
        result.held = k(kOutput, kOutput);
        const double free = result.held - coupling.dot(follow);
        result.free = free > kNothing * result.held ? free : 0.0;
        result.dead_band = dead_band(spring_torques(held_, rest->z), follow, result.free);
        return result;
    }

private:
    static constexpr double kNothing = 1e-12;  ///< of the held stiffness: rounding

    [[nodiscard]] double series_torque(const Eigen::Vector3d& z) const {
        const Eigen::Vector3d agonist(1.0, 0.0, held_.ratio());
        for (const JointSpring& spring : held_.springs)
            if (spring.jacobian_row == agonist) return spring.potential->force(spring.offset + spring.jacobian_row.dot(z));
        return 0.0;
    }
    [[nodiscard]] double dead_band(const Eigen::Vector3d& loads, const Eigen::VectorXd& follow, double free) const {
        if (free == 0.0) return std::numeric_limits<double>::infinity();
        double width = 0.0;
        for (std::size_t i = 0; i < motors_.size(); ++i) {
            const spring::FrictionLaw& gear = joint_.gear_friction[static_cast<std::size_t>(motors_[i])];
            width += 2.0 * gear.at_rest(loads(motors_[i])) * std::abs(follow(static_cast<Eigen::Index>(i))) / free;
        }
        return width;
    }

    Arrangement arrangement_;
    Joint joint_, held_;       ///< with its loops; without loops and with the output held
    std::vector<int> motors_;  ///< free to turn
};

std::string remark_of(const ArrangementOptions& options) {
    if (options.arrangement == Arrangement::kPnrvsa) return "K_PE leads from the joint to ground: the motor torques alone hold a position";
    if (options.position_stiffness == 0.0)
        return "torque control leaves no path from the joint to ground (a = b = 0): every place is neutral";
    return fmt::format("only the position loops, {:g} Nm/rad, lead to ground", options.position_stiffness);
}

}  // namespace

const char* to_string(Arrangement arrangement) {
    switch (arrangement) {
        case Arrangement::kPnrvsa:
            return "pnrvsa";
        case Arrangement::kSeriesElastic:
            return "series_elastic";
        case Arrangement::kSimpleAntagonist:
            return "simple_antagonist";
        case Arrangement::kQuasiAntagonist:
            return "quasi_antagonist";
        case Arrangement::kBidirectional:
            return "bidirectional";
        case Arrangement::kCrossCoupled:
            return "cross_coupled";
    }
    return "";
}

Joint make_arrangement(const ArrangementOptions& options) {
    validate(options);
    const std::array gears{options.gear_friction, options.gear_friction};
    Joint joint;
    if (options.arrangement == Arrangement::kPnrvsa) {
        joint = antagonist(options.parallel, options.series, options.series, options.parallel, gears, options.capstan_radius,
                           options.joint_radius);
    } else {
        joint.gear_friction = gears;
        joint.capstan_radius = options.capstan_radius;
        joint.joint_radius = options.joint_radius;
        joint.springs = springs_of(options, joint.ratio());
        joint.frozen[kAntagonist] = options.arrangement == Arrangement::kSeriesElastic;
    }
    if (options.position_stiffness == 0.0) return joint;
    const auto loop = std::make_shared<BothWays>(spring::make_polynomial({0.0, options.position_stiffness}));
    for (const int body : {kAgonist, kAntagonist})
        if (!joint.frozen[static_cast<std::size_t>(body)])
            joint.springs.push_back({fmt::format("position loop {}", body + 1), loop, Eigen::Vector3d::Unit(body)});
    return joint;
}

ArrangementRow survey(const ArrangementOptions& options, core::Range cocontraction) {
    core::require_positive("cocontraction.low", cocontraction.low, "Nm");
    core::require_within("cocontraction.high", cocontraction.high, cocontraction.low, std::numeric_limits<double>::max(), "Nm");
    const Survey survey(options);
    const Level least = survey.at(cocontraction.low), greatest = survey.at(cocontraction.high);
    ArrangementRow row{.arrangement = options.arrangement,
                       .stiffness = {least.held, least.held},
                       .free_stiffness = {least.free, least.free},
                       .dead_band = {least.dead_band, greatest.dead_band},
                       .remark = remark_of(options)};
    const auto widen = [](core::Range& range, double value) { range = {std::min(range.low, value), std::max(range.high, value)}; };
    constexpr int kLevels = 32;  // other than progressive springs have their extremes between the ends
    for (int i = 1; i <= kLevels; ++i) {
        const Level level = i == kLevels ? greatest : survey.at(cocontraction.low + cocontraction.width() * i / kLevels);
        widen(row.stiffness, level.held);
        widen(row.free_stiffness, level.free);
    }
    // eq. 5: opposed springs subtract, a single one does not, and those of a bidirectional joint add.
    const double opposed = greatest.series_torque - least.series_torque;
    const double torque = options.arrangement == Arrangement::kSeriesElastic   ? greatest.series_torque
                          : options.arrangement == Arrangement::kBidirectional ? 2.0 * greatest.series_torque
                                                                               : opposed;
    row.torque = options.joint_radius / options.capstan_radius * torque;
    return row;
}

}  // namespace fusee::actuator
