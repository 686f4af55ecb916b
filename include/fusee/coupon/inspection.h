#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fusee/core/csv.h"
#include "fusee/core/finding.h"
#include "fusee/coupon/calibration.h"

/// The inspection sheet of a finished part: deviations of its contour along the normal, filled in by the shop, and what they say about
/// offset, eccentricity and rotation of the contour (docs/theory/calibration.md, eq. 8 to 10).
namespace fusee::coupon {

/// What a row inspects.
enum class Inspected {
    kContour,  ///< the groove's floor on the working arc
    kRim,      ///< the rim of a roller cam
    kBore,     ///< diameter; the deviation is that of the diameter
    kKey,      ///< middle of the keyway, across it
    kFace,     ///< height of a face near its edge
};

/// One row: a place, what is allowed there, what was measured.
struct InspectionRow {
    Inspected item = Inspected::kContour;
    int number = 0;                    ///< as on the drawing
    double x = 0.0, y = 0.0, z = 0.0;  ///< body frame [m]
    double normal = 0.0;               ///< direction of the outward normal [rad]; NaN: none (bore, face)
    double nominal = 0.0;              ///< contour, rim: the arm there; bore: its diameter; key: its width [m]
    double low = 0.0, high = 0.0;      ///< allowed deviation [m]
    double deviation = 0.0;            ///< measured, above 0: material beyond the nominal (bore: too wide) [m]; NaN: not measured
};

struct InspectionSheet {
    std::string part;  ///< "k_se", "k_pe_mirrored"
    std::vector<InspectionRow> rows;
};

/// Is this the text of an inspection sheet, by its columns?
[[nodiscard]] bool is_inspection(std::string_view csv, const core::CsvMapping& mapping = {});
/// Columns part, item, number, x_mm, y_mm, z_mm, normal_deg, nominal_mm, allowed_low_mm, allowed_high_mm, measured_deviation_mm; an empty
/// cell of the last is a row without measurement.
/// @param file the name used in messages
/// @throws core::InvalidInput "file:line:column: ...": as core::parse_csv; an unknown item, two parts, a place without normal or arm, a
/// figure out of range; "file: measured_deviation_mm" if no row of the contour is filled
[[nodiscard]] InspectionSheet parse_inspection(std::string_view csv, const std::string& file, const core::CsvMapping& mapping = {});
/// The sheet to fill in, with a comment at its head. Deviations are empty cells.
[[nodiscard]] std::string empty_inspection(const InspectionSheet& sheet, const std::string& provenance);

/// deviation = offset + n.(ex, ey) + rotation (x n_y - y n_x) + form at every measured row of the contour.
struct ContourFit {
    std::vector<InspectionRow> rows;  ///< the measured ones of the contour
    Estimate offset, x, y, rotation;  ///< [m], [m], [m], [rad]
    bool shifts = false;              ///< false: the rows do not tell an eccentricity from the offset, and x and y are not fitted
    bool turns = false;               ///< false: nor a rotation from the eccentricity
    std::vector<double> form;         ///< what remains at each row [m]
};
/// Least squares. @pre a measured row of the contour
[[nodiscard]] ContourFit fit_contour(const InspectionSheet& sheet);

/// The key that holds a part's contour offset: "compensation.k_se_contour_mm".
[[nodiscard]] std::string contour_key(const std::string& part);

/// What the sheet says: figures "contour_offset" (with its key; that of a rim has none), "eccentricity_x", "eccentricity_y", "rotation";
/// findings "inspection.contour", ".eccentricity", ".rotation", ".form", ".bore", ".key", ".face", each against the sheet's allowed
/// deviation; a remark on the arm.
/// @param present as for calibrate
[[nodiscard]] Calibration inspect_contour(const InspectionSheet& sheet, const Present& present);

}  // namespace fusee::coupon
