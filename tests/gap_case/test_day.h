#pragma once
#include <cmath>
#include <random>

#include "fusee/gap_case/break_away.h"
#include "fusee/spring/friction.h"

namespace fusee::fixtures {

/// A test day: every side and direction at each motor torque, some repeats. The friction met scatters by `relative` of itself and by
/// `absolute` Nm, so that load = motor torque +- friction holds with the load's own friction, as in a test.
struct TestDay {
    double mu = 0.28, constant = 0.0;
    double relative = 0.0, absolute = 0.0;
    std::vector<double> motor_torques{0.1, 0.25, 0.5, 0.75, 1.0, 1.25};
    std::vector<std::string> sides{"agonist", "antagonist"};
    int repeats = 3;
};

inline std::vector<gap_case::BreakAway> measure(const TestDay& day, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0.0, 1.0);
    std::vector<gap_case::BreakAway> rows;
    for (const std::string& side : day.sides)
        for (const bool backdrive : {true, false})
            for (const double motor : day.motor_torques)
                for (int i = 0; i < day.repeats; ++i) {
                    const double sign = backdrive ? 1.0 : -1.0;
                    const double met = 1.0 + day.relative * normal(random), more = day.absolute * normal(random);
                    // load = motor + sign ((constant + mu load) met + more)
                    const double load = (motor + sign * (day.constant * met + more)) / (1.0 - sign * day.mu * met);
                    rows.push_back({side, backdrive, motor, load});
                }
    return rows;
}

inline const gap_case::FrictionLine& line_of(const gap_case::FrictionReport& report, const std::string& group) {
    for (const gap_case::FrictionLine& line : report.lines)
        if (line.group == group) return line;
    throw std::out_of_range(group);
}

inline const gap_case::FrictionRemark* remark_of(const gap_case::FrictionReport& report, const std::string& id) {
    for (const gap_case::FrictionRemark& remark : report.remarks)
        if (remark.id == id) return &remark;
    return nullptr;
}

}  // namespace fusee::fixtures
