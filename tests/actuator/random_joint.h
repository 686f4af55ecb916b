#pragma once
#include <algorithm>
#include <cmath>
#include <random>

#include "fusee/actuator/joint.h"
#include "fusee/spring/laws.h"
#include "fusee/spring/potential.h"

namespace fusee::actuator {

/// Antagonists whose springs all stiffen, each of the four with a random kind and size; random radii and ratio.
class RandomJoint {
public:
    explicit RandomJoint(unsigned seed) : random_(seed) {}

    double within(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

    spring::PotentialPtr spring(bool series) {
        const int kind = std::uniform_int_distribution<int>(0, 2)(random_);
        if (kind == 0) return spring::make_polynomial({within(0.0, 0.2), within(0.02, 1.0), within(0.0, 0.5), within(0.0, 0.2)});
        if (kind == 1) return spring::make_exponential(within(0.02, 1.0), within(0.2, 3.0), within(0.0, 0.3));
        spring::StictionLawOptions o{.k = std::pow(10.0, within(-1.0, 0.0)), .u = within(0.001, 0.05), .c = within(0.02, 0.3)};
        o.start_torque = spring::least_feasible_load(o) * within(1.05, 2.0);
        o.end_torque = o.start_torque * within(2.0, 6.0);
        const spring::SpringLawPtr law = *spring::make_stiction_law(o);
        return series ? spring::series_spring(law) : spring::parallel_spring(law);
    }

    Joint antagonist() {
        const std::array<spring::FrictionLaw, 2> gears{spring::FrictionLaw::proportional(within(0.0, 0.4)),
                                                       spring::FrictionLaw::affine(within(0.0, 0.05), within(0.0, 0.3), within(0.0, 0.4))};
        const double capstan = within(0.01, 0.05), joint = capstan * within(0.4, 2.5);
        return actuator::antagonist(spring(false), spring(true), spring(true), spring(false), gears, capstan, joint);
    }

    /// A place inside all four laws, which all begin at 0.
    Eigen::Vector3d place(const Joint& joint) {
        std::array<double, 4> end{};
        for (std::size_t i = 0; i < 4; ++i) end[i] = std::min(joint.springs[i].potential->domain().high, 4.0);
        const double theta_1 = within(0.05, 0.95) * std::min(end[0], end[1]), theta_2 = within(0.05, 0.95) * std::min(end[2], end[3]);
        const double least = std::max(-theta_1, theta_2 - end[2]), most = std::min(end[1] - theta_1, theta_2);
        return {theta_1, theta_2, (least + within(0.02, 0.98) * (most - least)) / joint.ratio()};
    }

private:
    std::mt19937 random_;
};

}  // namespace fusee::actuator
