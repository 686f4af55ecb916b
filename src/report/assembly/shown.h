#pragma once
#include <Eigen/Core>
#include <optional>

#include "fusee/assembly/motion.h"
#include "fusee/drawing/picture.h"

/// What pictures and the 3D scene show of a body beyond its shape.
namespace fusee::report {

/// The mesh of a body in its own frame: a cam swept again with fewer facets, which keeps its shape where a decimation would not.
[[nodiscard]] solid::Mesh shown_mesh(const assembly::Assembly& assembly, const assembly::Body& body);

/// How far a body is moved in the exploded view [mm]: along z, and along K_PE's cable.
[[nodiscard]] Eigen::Vector3d moved_apart(const assembly::Assembly& assembly, const assembly::Body& body);

/// The coils of a spring in a pose, in the frame of `shapes.front()`; none for other bodies and for springs of unknown coils.
[[nodiscard]] std::optional<drawing::Coil> coil_of(const assembly::Assembly& assembly, const assembly::Body& body,
                                                   const assembly::Pose& pose = {});

}  // namespace fusee::report
