#pragma once
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "fusee/inspect/rays.h"
#include "fusee/inspect/topology.h"

namespace fusee::inspect {

/// A place of the surface at which the material below it and the room above it are measured.
struct Sample {
    std::uint32_t triangle = 0;
    solid::Vec3 at_mm{};
    double share_mm2 = 0.0;  ///< of the surface; all shares together are its area
    /// Diameter of the largest ball in the material that touches the surface here and again at least 120 deg away; NaN where none does.
    double wall_mm = std::numeric_limits<double>::quiet_NaN();
    double taper = 0.0;       ///< angle between the two faces that it touches [rad]
    bool feather = false;     ///< they go on to meet in an edge, so that the wall has no least thickness
    solid::Vec3 middle_mm{};  ///< of that ball
    double ball_mm = 0.0;     ///< diameter of the largest ball in the material that touches the surface here, wherever else it does
    /// Like the wall, in the room outside and at least 150 deg apart: a slot, not the corner between two faces.
    double gap_mm = std::numeric_limits<double>::quiet_NaN();
};

/// What measuring the samples of a mesh may cost, in triangles looked at. A torus of a million triangles, the worst case of a sound part,
/// takes 7e8. A mesh of which a sample takes more than 100,000 consists of triangles that lie over one another: it gets a quarter. Placing
/// components gets a sixteenth.
inline constexpr std::size_t kMostLooks = 800'000'000;

/// A mesh made ready to be measured. Built once, then constant; every measure of it is a pure function.
class Body {
public:
    /// Components that face inward without being a cavity are turned (`turned`), so that the rest can be measured.
    /// @param samples places at which walls and gaps are measured; half of them are spread by area, half by triangle
    /// @param jobs threads, 0 = one for each processor; the result does not depend on them
    /// @param most_looks where measuring ends: places are taken in an order that spreads them, those left are left out
    /// @throws core::InvalidInput naming mesh.triangles, if a triangle names a missing point or none has an area
    explicit Body(solid::Mesh mesh, std::size_t samples = 20000, unsigned jobs = 0, std::size_t most_looks = kMostLooks);

    [[nodiscard]] const solid::Mesh& mesh() const { return mesh_; }
    [[nodiscard]] const solid::Box& box() const { return box_; }
    [[nodiscard]] const Topology& topology() const { return topology_; }
    [[nodiscard]] const Rays& rays() const { return rays_; }
    [[nodiscard]] const std::vector<solid::Vec3>& normals() const { return normals_; }  ///< by triangle, unit; zero without area
    [[nodiscard]] const std::vector<double>& areas_mm2() const { return areas_; }
    [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
    [[nodiscard]] const std::vector<bool>& cavity() const { return cavity_; }               ///< by component: it bounds a hollow inside
    [[nodiscard]] const std::vector<bool>& turned() const { return turned_; }               ///< by component: it faced inward
    [[nodiscard]] std::size_t samples_left_out() const { return samples_left_out_; }        ///< not measured: it would have cost too much
    [[nodiscard]] std::size_t components_left_out() const { return components_left_out_; }  ///< not looked at: cavity or turned
    [[nodiscard]] unsigned jobs() const { return jobs_; }

private:
    void measure_facets();
    void measure_samples(std::size_t most_looks);
    void measure_sample(Sample& sample) const;
    void keep_measured(const std::vector<bool>& measured);
    void place_components(std::size_t most_looks);

    solid::Mesh mesh_;
    unsigned jobs_;
    solid::Box box_;
    Topology topology_;
    Rays rays_;
    std::vector<solid::Vec3> normals_;
    std::vector<double> areas_;
    std::vector<bool> cavity_, turned_;
    std::vector<Sample> samples_;
    std::size_t samples_left_out_ = 0, components_left_out_ = 0;
};

/// Balls on the side to which `side` (unit) points that touch the surface at `at`. The ray along `side` bounds them from above; points
/// inside shrink them.
/// Shrinking ball: J. Ma, S. W. Bae, S. Choi, "3D medial axis point approximation using nearest neighbors and the normal field", The
/// Visual Computer 28 (2012). Its drawback: it measures edges too; a second contact nearer than asked for is an edge, not a wall, and
/// there the ray decides, if it ends on a face that looks away by as much.
struct Ball {
    double touching_mm = 0.0;                                       ///< diameter of the largest
    double opposite_mm = std::numeric_limits<double>::quiet_NaN();  ///< of the largest that touches again opposite; NaN: none does
    solid::Vec3 middle_mm{};                                        ///< of the latter
    std::uint32_t contact = kNone;                                  ///< the triangle opposite
};
/// @param apart cosine of the least angle between the two contacts @returns nothing where the ray meets no surface
[[nodiscard]] std::optional<Ball> ball_at(const Body& body, std::uint32_t triangle, const solid::Vec3& at, const solid::Vec3& side,
                                          double apart);

}  // namespace fusee::inspect
