#pragma once
#include <cmath>
#include <functional>
#include <random>

#include "fusee/coupon/calibration.h"

namespace fusee::coupon::test {

/// A machine and a cable with known values, and their sheet.
struct World {
    double shrink_x = 0.004, shrink_y = 0.006, shrink_z = -0.003;
    double contour_mm = 0.06;  ///< what outer lengths come out longer by
    double bore_offset_mm = 0.12, cable_axis_mm = 0.07;
    double series_rate = 0.02, parallel_rate = 7300.0;  ///< [Nm/rad], [N/m]
    double floor_mm = 15.0, cable_mm = 0.8, slack_mm = 2.5, drag_Nm = 0.01;

    [[nodiscard]] double in_plane() const { return 0.5 * (shrink_x + shrink_y); }
    [[nodiscard]] double radius_mm() const { return (1.0 - in_plane()) * floor_mm + 0.5 * cable_mm + cable_axis_mm; }

    /// @param noise standard deviations by the item's unit: mm of a caliper, everything else relative to it
    [[nodiscard]] Sheet sheet(const std::function<double(double)>& noise = [](double) { return 0.0; }) const {
        Sheet sheet;
        sheet.cable_diameter_mm = cable_mm;
        sheet.disc_floor_mm = floor_mm;
        const auto add = [&](Item item, double given, double exact, double scatter) {
            sheet.rows.push_back({item, given, exact + noise(scatter)});
        };
        for (int repeat = 0; repeat < 3; ++repeat)
            for (const double length : {16.0, 66.0}) {
                add(Item::kLengthX, length, (1.0 - shrink_x) * length + contour_mm, 0.02);
                add(Item::kLengthY, length, (1.0 - shrink_y) * length + contour_mm, 0.02);
            }
        for (int repeat = 0; repeat < 3; ++repeat)
            for (const double height : {5.0, 25.0}) add(Item::kLengthZ, height, (1.0 - shrink_z) * height, 0.02);
        for (const double bore : {6.0, 6.1, 6.2, 6.3, 6.4}) add(Item::kBore, bore, (1.0 - in_plane()) * bore - bore_offset_mm, 0.02);
        for (const double turns : {0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0})
            add(Item::kDiscPull, turns, slack_mm + 2.0 * core::kPi * radius_mm() * turns, 0.3);
        for (const double pull : {20.0, 40.0, 60.0, 80.0})
            add(Item::kSeriesSpring, pull, 4.0 + 1e-3 * pull * series_rate / std::pow(1e-3 * radius_mm(), 2), 0.02);
        for (const double travel : {5.0, 10.0, 15.0, 20.0}) add(Item::kParallelSpring, travel, 1e-3 * travel * parallel_rate, 0.5);
        return sheet;
    }
    /// Torque over tension instead of cable drawn off.
    [[nodiscard]] static Sheet by_torque(Sheet sheet, const World& world) {
        std::erase_if(sheet.rows, [](const Row& row) { return row.item == Item::kDiscPull; });
        for (const double tension : {5.0, 10.0, 20.0})
            sheet.rows.push_back({Item::kDiscTorque, tension, world.drag_Nm + 1e-3 * world.radius_mm() * tension});
        return sheet;
    }
};

inline Sheet without(Sheet sheet, Item item) {
    std::erase_if(sheet.rows, [item](const Row& row) { return row.item == item; });
    return sheet;
}

}  // namespace fusee::coupon::test
