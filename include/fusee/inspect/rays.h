#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "fusee/solid/mesh.h"

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

}  // namespace fusee::inspect
