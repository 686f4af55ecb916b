#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fusee/inspect/topology.h"
#include "fusee/solid/mesh.h"
#include "fusee/solid/mesh_faults.h"

namespace fusee::inspect {

/// Where a ray meets the surface.
struct Hit {
    std::uint32_t triangle = 0;
    double distance_mm = 0.0;
};

/// Rays and nearest points of any list of triangles, by a tree of oriented boxes. Triangles without area are left out. Reentrant. In double
/// precision; of triangles that are equally far, the first one counts.
class Rays {
public:
    /// @param jobs threads, 0 = one for each processor; the result does not depend on them
    explicit Rays(const solid::Mesh& mesh, unsigned jobs = 0);
    ~Rays();
    Rays(Rays&&) noexcept;
    Rays& operator=(Rays&&) noexcept;

    /// The first triangle along the ray, except `skip`. @param direction a unit vector
    [[nodiscard]] std::optional<Hit> first(const solid::Vec3& from, const solid::Vec3& direction, std::uint32_t skip) const;
    /// Every triangle along the ray, ascending.
    [[nodiscard]] std::vector<std::uint32_t> all(const solid::Vec3& from, const solid::Vec3& direction) const;
    /// The surface's point nearest to `at`, and a triangle that holds it; nothing if the distance is `within_mm` or more.
    [[nodiscard]] std::optional<std::pair<solid::Vec3, std::uint32_t>> nearest(const solid::Vec3& at, double within_mm) const;
    /// Triangles that this thread has visited, in any mesh. This is the cost of a query, the same on every machine.
    [[nodiscard]] static std::size_t visited();
    /// True if no triangle has an area.
    [[nodiscard]] bool empty() const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

/// A concave cylinder, or a part of one: a hole, or a rounded inner edge.
struct Hollow {
    solid::Vec3 axis{};       ///< unit
    solid::Vec3 middle_mm{};  ///< on the axis, half way
    double diameter_mm = 0.0;
    double length_mm = 0.0;         ///< along the axis
    double covers = 0.0;            ///< its extent about the axis [rad]
    bool open[2] = {false, false};  ///< at its far end along -axis and along +axis
    std::vector<std::uint32_t> triangles;

    /// It spans more than 200 degrees, unlike the end of a slot, and is longer than one ring of facets.
    [[nodiscard]] bool is_hole() const;
    [[nodiscard]] bool is_through() const { return open[0] && open[1]; }
};

/// The edge in which two faces meet ahead of a ball between them.
struct SharpEdge {
    double angle = 0.0;     ///< between the faces, in the material, where they are a tenth as far apart [rad]
    double width_mm = 0.0;  ///< of the material at the ball
    double way_mm = 0.0;    ///< from the ball to the edge
};

/// A point of the surface at which the thickness of the material below and the width of the gap above are measured.
struct Sample {
    std::uint32_t triangle = 0;
    solid::Vec3 at_mm{};
    double share_mm2 = 0.0;  ///< of the surface; all shares together are its area
    /// Distance between the two places where the largest ball in the material touches the surface: here, and at least 150 deg away. NaN
    /// where none does, and where the two faces meet in an edge ahead: an edge has no least thickness, so it is no wall.
    double wall_mm = std::numeric_limits<double>::quiet_NaN();
    solid::Vec3 middle_mm{};             ///< of that ball
    std::optional<SharpEdge> edge = {};  ///< in which the two faces meet
    double ball_mm = 0.0;  ///< diameter of the largest ball in the material that touches the surface here, with any second contact
    /// Like the wall, but outside and with contacts at least 150 deg apart: a slot, not the corner between two faces.
    double gap_mm = std::numeric_limits<double>::quiet_NaN();
};

/// Budget for the samples of a mesh, in visited triangles. A
/// mesh with more than 100,000 visits per sample consists of overlapping triangles: its budget is a quarter. The budget for placing
/// components is a sixteenth.
inline constexpr std::size_t kMostVisits = 800'000'000;

/// @throws core::InvalidInput naming mesh.triangles if a triangle names a missing point
void require_sound(const solid::Mesh& mesh);

/// A mesh prepared for measurements. Built once, then constant; every measurement is a pure function.
class Body {
public:
    /// Components that face inward without being a cavity are turned (`turned`), so that they can be measured.
    /// @param samples points at which walls and gaps are measured; half of them are spread by area, half by triangle
    /// @param jobs threads, 0 = one for each processor; the result does not depend on them
    /// @param most_visits budget of the measurement: points are taken in an order that spreads them, the remaining ones are left out
    /// @param topology of the mesh, where it is known @param stage called before each long stage, with its name
    /// @throws core::InvalidInput naming mesh.triangles if a triangle names a missing point or none has an area; core::Stopped at Ctrl-C
    explicit Body(solid::Mesh mesh, std::size_t samples = 20000, unsigned jobs = 0, std::size_t most_visits = kMostVisits,
                  std::optional<Topology> topology = {}, const std::function<void(const std::string&)>& stage = {});

    [[nodiscard]] const solid::Mesh& mesh() const { return mesh_; }
    [[nodiscard]] const solid::Box& box() const { return box_; }
    [[nodiscard]] const Topology& topology() const { return topology_; }
    [[nodiscard]] const Rays& rays() const { return rays_; }
    [[nodiscard]] const std::vector<solid::Vec3>& normals() const { return normals_; }  ///< by triangle, unit; zero without area
    [[nodiscard]] const std::vector<double>& areas_mm2() const { return areas_; }
    [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
    [[nodiscard]] const std::vector<Hollow>& hollows() const { return hollows_; }
    [[nodiscard]] const solid::Crossings& crossings() const { return crossings_; }
    [[nodiscard]] const std::vector<bool>& cavity() const { return cavity_; }               ///< by component: it bounds an inner cavity
    [[nodiscard]] const std::vector<bool>& turned() const { return turned_; }               ///< by component: it faced inward
    [[nodiscard]] std::size_t samples_left_out() const { return samples_left_out_; }        ///< not measured: the budget was spent
    [[nodiscard]] std::size_t components_left_out() const { return components_left_out_; }  ///< not classified as cavity or turned
    [[nodiscard]] unsigned jobs() const { return jobs_; }

private:
    void measure_facets();
    void measure_samples(std::size_t most_visits);
    void measure_sample(Sample& sample) const;
    void keep_measured(const std::vector<bool>& measured);
    void place_components(std::size_t most_visits);

    solid::Mesh mesh_;
    unsigned jobs_;
    solid::Box box_;
    Topology topology_;
    Rays rays_;
    std::vector<solid::Vec3> normals_;
    std::vector<double> areas_;
    std::vector<bool> cavity_, turned_;
    std::vector<Sample> samples_;
    std::vector<Hollow> hollows_;
    solid::Crossings crossings_;
    std::size_t samples_left_out_ = 0, components_left_out_ = 0;
};

/// Finds facets along one axis that turn by at most 75 degrees from one to the next around empty space, with their corners on one circle.
/// Facets may have any width, so a hole may be a prism of five sides or more. Holes of a mesh whose triangles do not follow the axis
/// (marching cubes) are not found. Sorted by their first triangle. O(triangles). Body::hollows() holds them.
[[nodiscard]] std::vector<Hollow> find_hollows(const Body& body);

/// Balls that touch the surface at `at` on the side of the unit vector `side`. The ray along `side` bounds them from above; points inside
/// shrink them, by more than a thousandth of the radius.
/// Shrinking ball: J. Ma, S. W. Bae, S. Choi, "3D medial axis point approximation using nearest neighbors and the normal field", The
/// Visual Computer 28 (2012). It also measures edges. A second contact nearer than `apart` is an edge, not a wall, and
/// there the ray decides, if it ends on a face that is turned away by as much.
struct Ball {
    double touching_mm = 0.0;  ///< diameter of the largest
    double opposite_mm =
        std::numeric_limits<double>::quiet_NaN();  ///< between the contacts of one with a second contact opposite; NaN: none
    solid::Vec3 middle_mm{};                       ///< between these
    solid::Vec3 opposite{};                        ///< unit, from the middle to its second contact
};
/// @param apart cosine of the least angle between the two contacts @returns nothing where the ray meets no surface
[[nodiscard]] std::optional<Ball> ball_at(const Body& body, std::uint32_t triangle, const solid::Vec3& at, const solid::Vec3& side,
                                          double apart);

}  // namespace fusee::inspect
