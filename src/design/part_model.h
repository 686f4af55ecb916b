#pragma once
#include <Eigen/Core>
#include <vector>

#include "fusee/design/budget.h"
#include "fusee/spring/potential.h"

namespace fusee::design::budget {

/// Errors of one built cam, its guide and its spring.
struct PartErrors {
    double contour = 0.0, cable = 0.0;  ///< of the distance between cable centreline and floor's axis, along the normal [m]
    Eigen::Vector2d runout{0.0, 0.0};   ///< of the contour against the shaft, in the body frame [m]
    double guide = 0.0;                 ///< across the cable [m]; of a parallel exit: direction [rad]
    double rate = 0.0, preload = 0.0;   ///< relative
    double zero = 0.0;                  ///< capstan angle at which the law begins [rad]
    [[nodiscard]] double offset() const { return contour + cable; }
};

/// A cam whose arms and torques follow from errors: linear (eq. 1 to 4), and exactly.
class PartModel {
public:
    /// @pre capstan_radius above 0
    PartModel(const PartSubject& subject, double capstan_radius);

    /// Places at which torques are compared: rows and capstan travels.
    [[nodiscard]] const std::vector<std::size_t>& places() const { return places_; }
    [[nodiscard]] double travel(std::size_t row) const { return rows_[row].travel; }
    [[nodiscard]] double torque(std::size_t row) const;

    /// Relative change of the torque at a row to first order (eq. 1 to 4).
    /// @pre this, `arms` and `spring`: the cam is on a cable
    [[nodiscard]] double linear(std::size_t row, const PartErrors& errors) const;
    /// The change of the torque at a row to first order [Nm], on a cable or a roller: eq. 1 to 3, 5.
    [[nodiscard]] double change(std::size_t row, const PartErrors& errors) const;
    /// The arms with tangents found anew [m], one for each row.
    [[nodiscard]] std::vector<double> arms(const PartErrors& errors) const;
    /// The spring at the capstan that follows from them, without `zero`; it continues a little beyond its ends.
    [[nodiscard]] spring::PotentialPtr spring(const PartErrors& errors) const;

private:
    struct Row {
        double angle, psi, h, rho, arm, slope, h_slope, state;
        double travel;                 ///< of the capstan [rad]
        double lever;                  ///< S = t . G - h' (eq. 1) [m]
        double across;                 ///< n . u: share of the guide's shift along the normal
        Eigen::Vector2d n;             ///< body frame
        Eigen::Vector2d guide, shift;  ///< guide and unit shift u in the body frame [m], 1
        double along, aside;           ///< of a roller: lift by an error along the contour's normal, by one of the line sideways
        double gap;                    ///< n . G - h of the drawing: 0 for a point, the radius of an idler [m]
    };
    [[nodiscard]] double arm_change(const Row& row, const PartErrors& errors) const;   ///< eq. 1
    [[nodiscard]] double lift_change(const Row& row, const PartErrors& errors) const;  ///< of a roller's follower, eq. 5
    [[nodiscard]] double exact_change(const Row& row, const PartErrors& errors) const;

    const PartSubject& subject_;
    double capstan_radius_;
    bool parallel_, rolls_;
    std::vector<Row> rows_;
    std::vector<std::size_t> places_;
    spring::PotentialPtr nominal_;
};

}  // namespace fusee::design::budget
