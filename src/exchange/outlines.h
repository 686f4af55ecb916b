#pragma once
#include <functional>
#include <string>

#include "fusee/exchange/dxf.h"
#include "fusee/solid/outline.h"

/// Curves of a part as entities of a drawing.
namespace fusee::exchange {

/// A curve that runs along the contour.
using Curve = std::function<solid::OutlinePoint(const cam::PathPoint&)>;

/// The pitch curve's parallel at a distance along its normal [mm].
[[nodiscard]] Curve parallel(double offset_mm);
/// The curve over the groove, within `kDrawingChord_mm`; closed for a planar part.
[[nodiscard]] DxfPolyline sampled(const cam::Cam& cam, const Curve& outline);
/// An exact outline: a circle, or a closed polygon within `kDrawingChord_mm`.
[[nodiscard]] DxfLayer layer_of(const std::string& name, const solid::Outline& outline);
/// The hub whose bore a beam of that width cuts: every side moved inwards by half of it; a key's depth and a flat's, from the bore's
/// radius, stay as they are.
[[nodiscard]] solid::HubOptions narrowed(solid::HubOptions hub, double kerf_mm);

}  // namespace fusee::exchange
