#include "fusee/checks/along.h"

#include <array>
#include <cmath>

#include "fusee/core/units.h"
#include "measure.h"
#include "shape.h"

namespace fusee::checks {

double bend_ratio(const cam::Contact& contact, double d) { return (2.0 * contact.path.rho - d) / d; }

double floor_pressure(const cam::Contact& contact, double d) {
    return 2.0 * contact.path.rho <= d ? 0.0 : 2.0 * contact.arm.tension / ((2.0 * contact.path.rho - d) * d);
}

std::span<const AlongCam> along_cam() {
    static constexpr std::array<AlongCam, 3> kAll{
        {{"cable.bend_ratio", [](const cam::Cam& cam, const cam::Contact& c) { return bend_ratio(c, cam.options.cable_diameter); }},
         {"cable.pressure",
          [](const cam::Cam& cam, const cam::Contact& c) { return floor_pressure(c, cam.options.cable_diameter) / kPaPerMPa; }},
         {"cable.fleet",
          [](const cam::Cam& cam, const cam::Contact& c) { return core::deg_from_rad(std::abs(fleet_from_groove(cam, c))); }}}};
    return kAll;
}

}  // namespace fusee::checks
