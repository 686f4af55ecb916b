#pragma once
#include <functional>
#include <string>

#include "fusee/exchange/dxf.h"
#include "fusee/solid/outline.h"

/// Curves of a part as entities of a drawing.
namespace fusee::exchange {

/// A curve that runs along the contour.
using Curve = std::function<solid::OutlinePoint(const cam::PathPoint&)>;

/// The parallel of the pitch curve at a distance along its normal [mm].
[[nodiscard]] Curve parallel(double offset_mm);
/// The curve over the groove, within `kDrawingChord_mm`; closed for a planar part.
[[nodiscard]] DxfPolyline sampled(const cam::Cam& cam, const Curve& outline);
/// The layer of an opening: its name in capitals.
[[nodiscard]] std::string layer_name(const std::string& opening);
/// An exact outline: a circle, or a closed chain of arcs and lines.
[[nodiscard]] DxfLayer layer_of(const std::string& name, const solid::Outline& outline);
/// The bore of the hub as the path of a beam of this width: every side is moved inwards by half the width. The depths of keyway and flat
/// from the radius of the bore stay unchanged.
[[nodiscard]] solid::HubOptions narrowed(solid::HubOptions hub, double kerf_mm);

/// The pivot of a roller's arm in the world: as PART.json states it, and as a drawing shows it.
[[nodiscard]] solid::Point2 arm_pivot_mm(const cam::Roller& roller);

}  // namespace fusee::exchange
