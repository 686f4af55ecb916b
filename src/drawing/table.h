#pragma once
#include <string>
#include <vector>

#include "fusee/drawing/sheet.h"
#include "fusee/solid/part.h"

namespace fusee::drawing {

/// A table of numbers that may continue in the next column.
struct Table {
    std::vector<std::string> title;
    std::vector<std::vector<std::string>> head;  ///< rows above the rule
    std::vector<std::vector<std::string>> rows;
    [[nodiscard]] double width() const;  ///< [mm]
};

/// The working arc at equal distances: place, normal, arm, and what an error of the radius is worth.
[[nodiscard]] Table check_table(const solid::Part& part);
/// Radii every 10 degrees.
[[nodiscard]] Table inspection_table(const solid::Part& part);
/// Arm, tension and torque at 25 of the working positions, evenly spaced, including the first and the last.
[[nodiscard]] Table torque_table(const cam::Cam& cam);

/// Writes title, head and as many rows as fit above `bottom`, from row `first` on. @returns the next row
[[nodiscard]] std::size_t write_table(Sheet& sheet, const Table& table, std::size_t first, const Point& corner, double bottom);

}  // namespace fusee::drawing
