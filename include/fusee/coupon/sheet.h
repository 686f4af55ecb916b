#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/core/csv.h"
#include "fusee/core/units.h"

/// Coupons that a workshop makes before the cams, and the sheet with their measurements of process and cable (docs/theory/calibration.md).
namespace fusee::coupon {

/// The quantity of a row.
enum class Item {
    kCableDiameter,  ///< as in the profile; drawn, not measured
    kDiscFloor,      ///< radius of the disc's floor; drawn, not measured
    kLengthX,        ///< between outer faces
    kLengthY,
    kLengthZ,
    kBore,            ///< diameter of a hole
    kShaft,           ///< diameter of the shaft that goes into the holes
    kShaftEnters,     ///< does the shaft enter the hole drawn with that diameter?
    kCableSeats,      ///< does the cable lie on the floor of the groove drawn with that radius ratio?
    kDiscPull,        ///< cable drawn off over turns of the disc
    kDiscTorque,      ///< torque of the disc over the cable's tension
    kSeriesSpring,    ///< force at the disc's cable over its pull, the disc on K_SE's torsion spring
    kParallelSpring,  ///< force of K_PE's compression spring over its travel
};

/// How an item appears in the sheet.
struct ItemKind {
    Item item;
    const char* name;        ///< column item
    const char* given_unit;  ///< column given_unit
    const char* unit;        ///< column unit, of the measured value; "-": not measured
    core::Range given;       ///< allowed range, in that unit
    core::Range measured;
    const char* how;  ///< instruction for the measurement
};
[[nodiscard]] std::span<const ItemKind> item_kinds();

/// A filled row, in the units of its item.
struct Row {
    Item item = Item::kLengthX;
    double given = 0.0, measured = 0.0;
};

/// A filled sheet, without the empty rows.
struct Sheet {
    double cable_diameter_mm = 0.0;  ///< 0: not given
    double disc_floor_mm = 0.0;      ///< 0: not given
    std::vector<Row> rows;           ///< in the file's order
    [[nodiscard]] std::vector<Row> of(Item item) const;
};

/// Columns item, given, given_unit, measured, unit; an empty cell of `measured` is a row without measurement. Yes is 1, no is 0.
/// @param file the name used in messages
/// @throws core::InvalidInput "file:line:column: ...": as core::parse_csv; an unknown item, another unit, a figure out of range, a drawn
/// figure given twice; "file: measured" if no row is filled
[[nodiscard]] Sheet parse_sheet(std::string_view csv, const std::string& file, const core::CsvMapping& mapping = {});

/// Nominal values of the coupons of a profile: the rows of their sheet.
struct Drawn {
    double cable_diameter_mm = 0.0;
    double disc_floor_mm = 0.0;
    double shaft_mm = 0.0;
    std::vector<double> x_mm, y_mm, z_mm;  ///< lengths along each axis, outer face to outer face
    std::vector<double> bores_mm;          ///< rising
    std::vector<double> groove_ratios;     ///< rising
    double disc_turns = 0.0;               ///< of cable that can be drawn off
};
/// The sheet to fill, with a comment at its head. @param provenance of the coupons
[[nodiscard]] std::string empty_sheet(const Drawn& drawn, const std::string& provenance);

/// README.md of a folder of coupons: its files, how to make the coupons, and what to measure for each row of the sheet.
[[nodiscard]] std::string readme(const Drawn& drawn, const std::string& provenance);

}  // namespace fusee::coupon
