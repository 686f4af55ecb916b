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

/// Torques and stiffnesses of both springs at any angle.
spring::LawPoint beyond(const spring::SpringLaw& law, double theta) {
    const core::Range angles = law.angles();
    const double inside = std::clamp(theta, angles.low, angles.high);
    spring::LawPoint p = law.at_angle(inside);
    p.f_se += (theta - inside) * p.s;
    p.f_pe += (theta - inside) * p.p;
    return p;
}

double angle_at(const spring::SpringLaw& law, double load) {
    const core::Range loads = law.loads();
    const spring::LawPoint p = law.at_load(std::clamp(load, loads.low, loads.high));
    return p.theta + (load - p.tau) / (p.s + p.p);
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

std::optional<Edges> find_edges(const spring::SpringLaw& law, core::Range loads) {
    constexpr int kMostSteps = 80;
    constexpr double kSettled = 1e-13;
    Edges e{angle_at(law, loads.low), angle_at(law, loads.high)};
    const double longest = std::max(0.05 * law.angles().width(), 0.25 * (e.high - e.low));
    for (int i = 0; i < kMostSteps; ++i) {
        const spring::LawPoint one = beyond(law, e.low), two = beyond(law, e.high), middle = beyond(law, 0.5 * (e.low + e.high));
        const double r1 = one.f_pe + middle.f_se - loads.low, r2 = two.f_pe + middle.f_se - loads.high;
        const double half = 0.5 * middle.s;  // the middle angle moves half as far as each capstan
        const double a = one.p + half, b = two.p + half, determinant = a * b - half * half;
        const double d1 = (b * r1 - half * r2) / determinant, d2 = (a * r2 - half * r1) / determinant;
        const double far = std::max(std::abs(d1), std::abs(d2));
        if (!std::isfinite(far)) return std::nullopt;
        const double share = far > longest ? longest / far : 1.0;
        e.low -= share * d1;
        e.high -= share * d2;
        if (far < kSettled * (1.0 + std::abs(e.high))) return e;
    }
    return std::nullopt;
}

}  // namespace fusee::search::codesign
