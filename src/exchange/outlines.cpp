#include "outlines.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "fusee/core/units.h"

namespace fusee::exchange {

namespace {

constexpr double kChord = kDrawingChord_mm;
constexpr double kLargest = 0.05;  // largest step in psi [rad]
constexpr double kRoller = 0.25;   // factor on the steps of a roller's rim: there the arm is the slope

}  // namespace

// The step depends on the radius of curvature: sagitta = rho dpsi^2 / 8.
DxfPolyline sampled(const cam::Cam& cam, const Curve& outline) {
    DxfPolyline line;
    line.closed = cam.closed();
    const core::Range range = cam.groove_psi;
    for (double psi = range.low; psi < range.high - 1e-9;) {
        const solid::OutlinePoint here = outline(cam.path(psi));
        line.points_mm.push_back(here.point);
        const double trial = std::min(psi + kLargest, range.high);
        const double rho = std::max(std::abs(here.rho), std::abs(outline(cam.path(trial)).rho));
        psi += (cam.has_roller() ? kRoller : 1.0) * std::min(kLargest, std::sqrt(8.0 * kChord / std::max(rho, 1e-3)));
    }
    if (!line.closed) line.points_mm.push_back(outline(cam.path(range.high)).point);
    return line;
}

Curve parallel(double offset_mm) {
    return [offset_mm](const cam::PathPoint& p) { return solid::flange_point(p, offset_mm, 0.0); };
}

std::string layer_name(const std::string& opening) {
    std::string name;
    for (const char c : opening) name.push_back(static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
    return name;
}

DxfLayer layer_of(const std::string& name, const solid::Outline& outline) {
    if (outline.size() == 1 && outline.front().full()) return {name, {}, {{outline.front().centre_mm, outline.front().radius_mm}}};
    DxfLayer layer{name, {}, {}};
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const solid::Arc &arc = outline[i], &next = outline[(i + 1) % outline.size()];
        if (arc.radius_mm > 0.0)
            layer.arcs.push_back({arc.centre_mm, arc.radius_mm, core::deg_from_rad(arc.begin), core::deg_from_rad(arc.end)});
        layer.lines.push_back({arc.at(arc.end), next.at(next.begin)});
    }
    return layer;
}

solid::HubOptions narrowed(solid::HubOptions hub, double kerf_mm) {
    hub.bore_clearance -= core::m_from_mm(kerf_mm);
    hub.key_width -= core::m_from_mm(kerf_mm);
    return hub;
}

}  // namespace fusee::exchange
