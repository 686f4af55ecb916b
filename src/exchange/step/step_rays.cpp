#include "step_rays.h"

#include <BRepBndLib.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <BRep_Tool.hxx>
#include <GeomConvert_BSplineSurfaceToBezierSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <IntCurvesFace_Intersector.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>

namespace fusee::exchange {

namespace {

constexpr double kFarthest_mm = 1e4;
constexpr double kRay_mm = 1e-7;

BezierPatch patch_of(const Geom_BezierSurface& surface) {
    BezierPatch patch{surface.NbUPoles(), surface.NbVPoles(), {}};
    for (int i = 1; i <= patch.rows; ++i)
        for (int j = 1; j <= patch.columns; ++j) {
            const gp_Pnt p = surface.Pole(i, j);
            const double w = surface.Weight(i, j);
            patch.poles.push_back({w * p.X(), w * p.Y(), w * p.Z(), w});
        }
    return patch;
}

/// Can the ray meet the box beyond `beyond_mm`?
bool meets(const Bnd_Box& box, double azimuth, double z_mm, double beyond_mm) {
    double x0 = 0.0, y0 = 0.0, z0 = 0.0, x1 = 0.0, y1 = 0.0, z1 = 0.0;
    box.Get(x0, y0, z0, x1, y1, z1);
    if (z_mm < z0 || z_mm > z1) return false;
    const double c = std::cos(azimuth), s = std::sin(azimuth);
    const double along = std::max(c * x0, c * x1) + std::max(s * y0, s * y1);
    const double left = std::max(-s * x0, -s * x1) + std::max(c * y0, c * y1),
                 right = std::min(-s * x0, -s * x1) + std::min(c * y0, c * y1);
    return along > beyond_mm && left >= 0.0 && right <= 0.0;
}

}  // namespace

StepRays::StepRays(const TopoDS_Shape& shape) {
    for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next()) {
        Face face{
            TopoDS::Face(at.Current()), Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(at.Current()))), {}, {}, {}};
        constexpr int kPoles = BezierPatch::kMostPoles;
        const bool divisible = !face.spline.IsNull() && face.spline->UDegree() < kPoles && face.spline->VDegree() < kPoles &&
                               !face.spline->IsUPeriodic() && !face.spline->IsVPeriodic();
        if (divisible) {
            face.trim = std::make_unique<BRepTopAdaptor_FClass2d>(face.face, kRay_mm);
            splines_.push_back(std::move(face));
            divide(splines_.size() - 1);
        } else {
            BRepBndLib::Add(face.face, face.box);
            face.search = std::make_unique<IntCurvesFace_Intersector>(face.face, kRay_mm);
            others_.push_back(std::move(face));
        }
    }
}

StepRays::~StepRays() = default;

void StepRays::divide(std::size_t face) {
    GeomConvert_BSplineSurfaceToBezierSurface bezier(splines_[face].spline);
    const int across = bezier.NbUPatches(), along = bezier.NbVPatches();
    TColStd_Array1OfReal u(1, across + 1), v(1, along + 1);
    bezier.UKnots(u);
    bezier.VKnots(v);
    for (int i = 1; i <= across; ++i)
        for (int j = 1; j <= along; ++j) {
            Piece piece{
                patch_of(*bezier.Patch(i, j)), face, u(i), v(j), u(i + 1) - u(i), v(j + 1) - v(j), kFarthest_mm, -kFarthest_mm, 0.0};
            std::vector<std::array<double, 2>> hull;
            for (const auto& [x, y, z, w] : piece.patch.poles) {
                hull.push_back({x / w, y / w});
                piece.low_mm = std::min(piece.low_mm, z / w - kRay_mm);
                piece.high_mm = std::max(piece.high_mm, z / w + kRay_mm);
                piece.farthest_mm = std::max(piece.farthest_mm, std::hypot(x / w, y / w));
            }
            bins_.add(static_cast<std::uint32_t>(pieces_.size()), hull);
            pieces_.push_back(std::move(piece));
        }
}

/// 0: the ray does not meet the face there.
double StepRays::farthest_on(const Piece& piece, double azimuth, double z_mm) const {
    double farthest = 0.0;
    for (const PatchPoint& at : crossings(piece.patch, azimuth, z_mm)) {
        const Face& face = splines_[piece.face];
        const double u = piece.u + at.s * piece.width_u, v = piece.v + at.t * piece.width_v;
        const gp_Pnt p = face.spline->Value(u, v);
        const double along = p.X() * std::cos(azimuth) + p.Y() * std::sin(azimuth);
        if (along > farthest && face.trim->Perform(gp_Pnt2d(u, v)) != TopAbs_OUT) farthest = along;
    }
    return farthest;
}

std::optional<double> StepRays::outermost(double azimuth, double z_mm) const {
    double farthest = 0.0;
    for (const std::uint32_t i : bins_.at(azimuth))
        if (const Piece& piece = pieces_[i]; z_mm >= piece.low_mm && z_mm <= piece.high_mm && piece.farthest_mm > farthest)
            farthest = std::max(farthest, farthest_on(piece, azimuth, z_mm));
    const gp_Lin ray(gp_Pnt(0.0, 0.0, z_mm), gp_Dir(std::cos(azimuth), std::sin(azimuth), 0.0));
    for (const Face& face : others_) {
        if (!meets(face.box, azimuth, z_mm, farthest)) continue;
        face.search->Perform(ray, 0.0, kFarthest_mm);
        for (int k = 1; face.search->IsDone() && k <= face.search->NbPnt(); ++k) farthest = std::max(farthest, face.search->WParameter(k));
    }
    return farthest > 0.0 ? std::optional(farthest) : std::nullopt;
}

}  // namespace fusee::exchange
