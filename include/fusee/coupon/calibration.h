#pragma once
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "fusee/core/units.h"
#include "fusee/coupon/sheet.h"

namespace fusee::coupon {

/// A figure with its standard uncertainty, as the Guide to the Expression of Uncertainty in Measurement combines them (JCGM 100:2008).
struct Estimate {
    double value = 0.0;
    double deviation = 0.0;  ///< u, standard uncertainty
    double freedom = 0.0;    ///< degrees of freedom of u; infinite where it is known

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
/// Least squares. What the gauge cannot tell apart is scatter too: a row's deviation is at least `resolution`/sqrt(12).
/// @pre at least 3 rows, x not all alike
[[nodiscard]] Line fit_line(const std::vector<Row>& rows, double resolution);

/// One figure that the sheet gives, and where it goes.
struct Figure {
    std::string id;         ///< "shrink_x", "contour_x", "bore_offset", "disc_radius", "cable_axis", "groove_ratio", "series_rate", ...
    std::string what;       ///< in a few words
    std::string key;        ///< of the profile; "": none has it
    std::string unit;       ///< in which a person reads it: "%", "mm", "Nm/rad", "N/m", ""
    double per_unit = 1.0;  ///< figure in `unit` = figure [SI] times this
    double value = 0.0;     ///< [SI]
    core::Range range;      ///< 95 % interval; of a ladder the two rungs that it lies between [SI]
    bool ladder = false;
    std::size_t rows = 0;
    double present = std::numeric_limits<double>::quiet_NaN();  ///< what the profile says [SI]; NaN: unknown
    /// The profile's figure stays unless the rows contradict it.
    [[nodiscard]] bool changes() const { return !key.empty() && !range.holds(present); }
    /// What a part is compensated by.
    [[nodiscard]] double used() const { return changes() ? value : present; }
};

/// What a sheet cannot say, and what it would take.
struct Unknown {
    std::string id, why;
};

struct Calibration {
    std::vector<Figure> figures;
    std::vector<Unknown> unknown;
    std::vector<std::string> remarks;
    [[nodiscard]] const Figure* find(const std::string& id) const;  ///< nullptr if unknown
};

/// Figures of the profile that the coupons were made from, by key [SI]: what stands there already.
using Present = std::map<std::string, double>;

/// The keys that a calibration can change.
inline constexpr const char *kShrinkKeys[] = {"compensation.shrink_x_percent", "compensation.shrink_y_percent",
                                              "compensation.shrink_z_percent"},
                            *kBoreOffsetKey = "compensation.bore_offset_mm", *kCableAxisKey = "compensation.cable_axis_mm",
                            *kGrooveRatioKey = "groove.radius_ratio", *kSeriesRateKey = "k_se.spring.rate_Nm_per_rad",
                            *kParallelRateKey = "k_pe.spring.rate_N_per_m";

/// Shrinkage by axis from lengths, bore offset from holes, the cable's neutral axis from the disc, the groove that fits, rates of the base
/// springs (docs/theory/calibration.md, eq. 1 to 6). A compensation that `present` does not name is 0.
/// @param file the name used in messages
/// @throws core::InvalidInput naming `file` for answers that contradict each other: a shaft or cable that fits less in more room
[[nodiscard]] Calibration calibrate(const Sheet& sheet, const Present& present, const std::string& file);

}  // namespace fusee::coupon
