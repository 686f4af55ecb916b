#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fusee/solid/mesh.h"

/// Shaded pictures of meshes by a depth buffer, in parallel projection: what is in front hides what is behind.
/// Meshes of wires for pictures: cables and the coils of springs.
namespace fusee::drawing {

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue (sRGB)

/// A mesh in the scene's frame [mm].
struct Object {
    solid::Mesh mesh;
    Colour colour{160, 160, 160};
};

/// Directions of a parallel projection in the scene's frame: orthonormal, right x up = towards.
struct Projection {
    Eigen::Vector3d right = Eigen::Vector3d::UnitX(), up = Eigen::Vector3d::UnitY();
    Eigen::Vector3d towards = Eigen::Vector3d::UnitZ();  ///< towards the eye
    /// Where a point is seen: to the right and up [mm].
    [[nodiscard]] Eigen::Vector2d seen(const Eigen::Vector3d& point_mm) const { return {right.dot(point_mm), up.dot(point_mm)}; }
};
/// The view from a direction: azimuth from +x towards +y, elevation above the plane z = 0 [rad]; z points up. @pre |elevation| < 90 deg
[[nodiscard]] Projection from_direction(double azimuth, double elevation);

/// The part of an object that is not hidden.
struct Visible {
    std::size_t pixels = 0;                                ///< 0: hidden
    Eigen::Vector2d middle_mm = Eigen::Vector2d::Zero();   ///< their mean, as Projection::seen; may be on another object
    Eigen::Vector2d nearest_mm = Eigen::Vector2d::Zero();  ///< the object's pixel nearest to that mean
};

/// Rows of pixels from the upper left corner, three bytes each, on white.
struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
    Eigen::Vector2d low_mm = Eigen::Vector2d::Zero(), high_mm = Eigen::Vector2d::Zero();  ///< of the picture's edges, as Projection::seen
    std::vector<Visible> visible;                                                         ///< in the order of the objects
    [[nodiscard]] double pixel_mm() const { return (high_mm.x() - low_mm.x()) / width; }
};

/// Faces are lit from the upper left in front; edges are drawn where two objects, or two faces at more than 30 degrees, meet in the
/// picture. The same bytes for the same input.
/// @param longest_px width or height, whichever is larger @throws InvalidInput naming longest_px unless 16 to 8000
[[nodiscard]] Picture draw(std::span<const Object> objects, const Projection& view, int longest_px);

/// The same view of several scenes, all of one size and at one place: the frames of a motion. @throws InvalidInput as draw
[[nodiscard]] std::vector<Picture> draw_frames(const std::vector<std::vector<Object>>& frames, const Projection& view, int longest_px);

/// The picture as a PNG file. @throws IoError without memory for it
[[nodiscard]] std::string png(const Picture& picture);
/// Pictures one after another, for ever, as an animated PNG: a program that knows none shows the first. @pre one picture at least, all of
/// one size @param frame_ms how long each is shown [ms] @throws IoError as png
[[nodiscard]] std::string animated_png(const std::vector<Picture>& frames, int frame_ms);
/// "data:image/png;base64,...": a picture inside an SVG or HTML file.
[[nodiscard]] std::string data_uri(const std::string& png);

/// A tube of `sides` sides along a line of points [mm], closed at both ends. @pre two points at least, none twice in a row
[[nodiscard]] solid::Mesh tube(const std::vector<Eigen::Vector3d>& line_mm, double radius_mm, int sides = 8);

/// A coil spring about the z axis, from z = 0 to `length_mm` [mm]. @pre lengths and turns above 0
struct Coil {
    double mean_radius_mm = 0.0, wire_mm = 0.0;
    double length_mm = 0.0;  ///< outside to outside
    double turns = 0.0;
    bool left_hand = false;
};
[[nodiscard]] solid::Mesh coil_mesh(const Coil& coil);

}  // namespace fusee::drawing
