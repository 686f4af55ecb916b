#pragma once
#include <string>
#include <vector>

#include "fusee/drawing/sheet.h"
#include "fusee/solid/part.h"

namespace fusee::drawing {

/// A table of numbers that may go on in the next column.
struct Table {
    std::vector<std::string> title;
    std::vector<std::vector<std::string>> head;  ///< rows above the rule
    std::vector<std::vector<std::string>> rows;
    [[nodiscard]] double width() const;  ///< [mm]
};

/// Radii every 10 degrees.
[[nodiscard]] Table inspection_table(const solid::Part& part);
/// Arm, tension and torque at 25 of the working positions, evenly spaced, the first and the last among them.
[[nodiscard]] Table torque_table(const cam::Cam& cam);

/// Writes title, head and as many rows as have room above `bottom`, beginning with row `first`. @returns the row to go on with
[[nodiscard]] std::size_t write_table(Sheet& sheet, const Table& table, std::size_t first, const Point& corner, double bottom);

}  // namespace fusee::drawing
