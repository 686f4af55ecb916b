#pragma once
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/core/units.h"
#include "fusee/coupon/sheet.h"

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

}  // namespace fusee::coupon
