#include <limits>

#include "fusee/checks/limits.h"
#include "fusee/drawing/drawing.h"
#include "fusee/drawing/inspection.h"
#include "fusee/solid/outline.h"
#include "tolerances.h"

namespace fusee::drawing {

namespace {

using coupon::Inspected, coupon::InspectionRow;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

InspectionRow bore_row(const Subject& subject) {
    const solid::HubOptions& hub = subject.part.options.hub;
    const core::Range fit = checks::process_limits(subject.process).fit;
    InspectionRow row{Inspected::kBore, 1, 0.0, 0.0, subject.part.z_low - hub.boss_height, kNone};
    row.nominal = hub.bore_diameter + hub.bore_clearance;
    row.low = fit.low - hub.bore_clearance;
    row.high = fit.high - hub.bore_clearance;
    row.deviation = kNone;
    return row;
}

}  // namespace

coupon::InspectionSheet inspection_sheet(const Subject& subject) {
    const solid::Part& part = subject.part;
    const solid::HubOptions& hub = part.options.hub;
    const Tolerances t = tolerances_of(subject);
    coupon::InspectionSheet sheet{subject.name, {}};
    int number = 0;
    for (const CheckRow& at : check_rows(part)) {
        const Inspected item = part.cam.has_roller() ? Inspected::kRim : Inspected::kContour;
        sheet.rows.push_back({item, ++number, at.x, at.y, at.z, at.normal, at.arm, -0.5 * t.contour, 0.5 * t.contour, kNone});
    }
    sheet.rows.push_back(bore_row(subject));
    if (hub.lock == solid::HubLock::kKeyway)
        sheet.rows.push_back({Inspected::kKey, 1, 0.5 * hub.bore_diameter, 0.0, part.z_low - hub.boss_height, 0.5 * core::kPi,
                              hub.key_width, -0.5 * t.position, 0.5 * t.position, kNone});
    const CheckRow rim = arc_ends(part).front();
    sheet.rows.push_back({Inspected::kFace, 1, rim.x, rim.y, part.z_high, kNone, 0.0, -0.5 * t.runout, 0.5 * t.runout, kNone});
    return sheet;
}

}  // namespace fusee::drawing
