#include "shape.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fusee/cam/contact.h"

namespace fusee::search::codesign {

namespace {

constexpr int kContacts = 120;  // of each spacing: a law that is soft at its start is crowded in load, a stiff one in angle

std::vector<double> loads_of(const spring::SpringLaw& law) {
    std::vector<double> loads;
    const core::Range range = law.loads(), angles = law.angles();
    for (int i = 0; i <= kContacts; ++i) {
        const double share = static_cast<double>(i) / kContacts;
        loads.push_back(range.low + share * range.width());
        loads.push_back(law.at_angle(angles.low + share * angles.width()).tau);
    }
    return loads;
}

}  // namespace

Shape shape_of(const cam::ArmFunction& arm, const cam::CamOptions& options) {
    Shape shape{1e9, 1e9, 0.0, 0.0};
    core::Range psi{1e9, -1e9};
    for (const double load : loads_of(arm.law())) {
        const cam::Contact c = cam::touch(arm.kind(), arm.at_load(load), options);
        if (!(c.path.rho >= shape.least_rho)) shape.least_rho = c.path.rho;
        shape.least_arm = std::min(shape.least_arm, c.arm.arm);
        shape.radius = std::max(shape.radius, std::hypot(c.path.h, c.path.slope));
        psi = {std::min(psi.low, c.path.psi), std::max(psi.high, c.path.psi)};
    }
    shape.wrap = psi.width();
    return shape;
}

double contour_radius(const cam::Cam& cam) {
    constexpr double kStep = 0.02;  // [rad]
    double radius = 0.0;
    const auto widen = [&radius](const cam::PathPoint& p) { radius = std::max(radius, std::hypot(p.h, p.slope)); };
    for (const cam::Contact& c : cam.working) widen(c.path);
    for (double psi = cam.groove_psi.low; psi < cam.working_psi.low; psi += kStep) widen(cam.path(psi));
    for (double psi = cam.working_psi.high; psi < cam.groove_psi.high; psi += kStep) widen(cam.path(psi));
    return radius;
}

}  // namespace fusee::search::codesign
