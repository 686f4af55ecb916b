#include "fusee/exchange/brep.h"
#include "fusee/solid/outline.h"
#include "strip.h"

namespace fusee::exchange::brep {

namespace {

PlaneSpline flattened(const Handle(Geom_BSplineCurve) & curve) {
    PlaneSpline plane;
    plane.degree = curve->Degree();
    for (int i = 1; i <= curve->NbKnots(); ++i)
        plane.knots.insert(plane.knots.end(), static_cast<std::size_t>(curve->Multiplicity(i)), curve->Knot(i));
    for (int i = 1; i <= curve->NbPoles(); ++i) plane.control_mm.push_back({curve->Pole(i).X(), curve->Pole(i).Y()});
    return plane;
}

}  // namespace

std::vector<PlaneSpline> outline_splines(const solid::Part& part, double offset_mm) {
    const Rail rail = [&](double psi) {
        const solid::Point2 p = solid::flange_point(part.cam.path(psi), offset_mm, 0.0).point;
        return solid::Vec3{p[0], p[1], 0.0};
    };
    std::vector<PlaneSpline> splines;
    for (const core::Range& psi : smooth_pieces(part.cam))
        splines.push_back(flattened(spline(rail, nodes_for({rail}, psi, allowed_mm(part.cam)))));
    return splines;
}

}  // namespace fusee::exchange::brep
