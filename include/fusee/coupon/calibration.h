#pragma once
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fusee/core/csv.h"
#include "fusee/core/finding.h"
#include "fusee/core/units.h"
#include "fusee/coupon/sheet.h"

/// The inspection sheet of a finished part: deviations of its contour along the normal, filled in by the shop, and what they say about
/// offset, eccentricity and rotation of the contour (docs/theory/calibration.md, eq. 8 to 10).
namespace fusee::coupon {

/// A value with its standard uncertainty, by the Guide to the Expression of Uncertainty in Measurement (JCGM 100:2008).
struct Estimate {
    double value = 0.0;
    double deviation = 0.0;  ///< u, standard uncertainty
    double freedom = 0.0;    ///< degrees of freedom of u; infinite if u is exact

    /// Student's t interval with the freedom rounded down (JCGM 100:2008, G.4.1).
    [[nodiscard]] core::Range interval(double confidence = 0.95) const;
};
/// sum_i c_i x_i of independent estimates; freedom by Welch and Satterthwaite (JCGM 100:2008, eq. G.2b).
struct Share {
    double factor;
    Estimate of;
};
[[nodiscard]] Estimate sum(const std::vector<Share>& shares);

/// A straight line through measured rows, y = at_0 + slope x.
struct Line {
    Estimate slope, at_0;
};
/// Least squares. The gauge's resolution counts as scatter: a row's deviation is at least `resolution`/sqrt(12).
/// @pre at least 3 rows, x not all equal
[[nodiscard]] Line fit_line(const std::vector<Row>& rows, double resolution);

/// One result of the sheet, with the key of the profile that it changes.
struct Figure {
    std::string id;         ///< "shrink_x", "contour_x", "bore_offset", "disc_radius", "cable_axis", "groove_ratio", "series_rate", ...
    std::string what;       ///< short description
    std::string key;        ///< of the profile; "": no key
    std::string unit;       ///< for display: "%", "mm", "Nm/rad", "N/m", ""
    double per_unit = 1.0;  ///< figure in `unit` = figure [SI] times this
    double value = 0.0;     ///< [SI]
    core::Range range;      ///< 95 % interval; for a ladder the two neighbouring rungs [SI]
    bool ladder = false;
    std::size_t rows = 0;
    double present = std::numeric_limits<double>::quiet_NaN();  ///< value in the profile [SI]; NaN: unknown
    /// The profile's value stays unless the rows contradict it.
    [[nodiscard]] bool changes() const { return !key.empty() && !range.holds(present); }
    /// The value for compensation.
    [[nodiscard]] double used() const { return changes() ? value : present; }
};

/// A value that the sheet does not determine, and the missing rows.
struct Unknown {
    std::string id, why;
};

struct Calibration {
    std::vector<Figure> figures;
    std::vector<Unknown> unknown;
    std::vector<std::string> remarks;
    core::Findings findings = {};                                   ///< of an inspected part, passes too
    [[nodiscard]] const Figure* find(const std::string& id) const;  ///< nullptr if unknown
};

/// Present values of the profile of the coupons, by key [SI].
using Present = std::map<std::string, double>;

/// The keys that a calibration can change.
inline constexpr const char *kShrinkKeys[] = {"compensation.shrink_x_percent", "compensation.shrink_y_percent",
                                              "compensation.shrink_z_percent"},
                            *kBoreOffsetKey = "compensation.bore_offset_mm", *kCableAxisKey = "compensation.cable_axis_mm",
                            *kContourKeys[] = {"compensation.k_se_contour_mm", "compensation.k_pe_contour_mm"},
                            *kGrooveRatioKey = "groove.radius_ratio", *kSeriesRateKey = "k_se.spring.rate_Nm_per_rad",
                            *kParallelRateKey = "k_pe.spring.rate_N_per_m";

/// Shrinkage by axis from lengths, bore offset from holes, the cable's neutral axis from the disc, the matching groove, rates of the base
/// springs (docs/theory/calibration.md, eq. 1 to 6). A compensation that is not in `present` is 0.
/// @param file the name used in messages
/// @throws core::InvalidInput naming `file` for contradicting answers: a shaft or cable that fits a smaller opening but not a larger one
[[nodiscard]] Calibration calibrate(const Sheet& sheet, const Present& present, const std::string& file);

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
