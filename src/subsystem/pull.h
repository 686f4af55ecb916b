#pragma once
#include <vector>

#include "fusee/subsystem/subsystem.h"

/// Pulls of a cam on a dynamometer, before any fit: what their rows can show, and whether they have the law's units and signs.
namespace fusee::subsystem {

/// Straight between rows, and beyond the ends along the end rows. @pre two rows or more
[[nodiscard]] double torque_at(const LawCurve& curve, double q);

/// y = zero + gain x by least squares.
struct Line {
    double zero = 0.0, gain = 0.0;
    double explained = 0.0;  ///< share of the squares about the mean of y
};
[[nodiscard]] Line line_through(const std::vector<double>& x, const std::vector<double>& y);

/// 1: the drive's torque rises with the angle, as a spring's does; -1: files that state the torque of the spring on the drive. From the
/// slope of the laws over the pulled angles. Without a slope: the sign of their mean torque.
[[nodiscard]] double orientation_of(const std::vector<Record>& records);

/// Whether the angle goes over one range of angles up and down, a tenth of the file's whole range or more, with a few rows each way.
/// Noise of the angle, and weights that were taken off in between, are no way back.
[[nodiscard]] bool turns_back(const std::vector<double>& q);

/// Scatter of a row of a pull about the straight line through its neighbours, what the law changes between them taken out [Nm].
[[nodiscard]] double scatter_of(const Record& record);

/// @throws core::InvalidInput for angles beyond the law, with the question whether they are degrees or have the other sign
void require_covered(const Record& record);

/// @throws core::InvalidInput with a question, where the torque follows the law only in another unit or with another sign: Nmm for Nm,
/// degrees for radians, a torque that falls where its law rises
void require_same_units(const Record& record);

}  // namespace fusee::subsystem
