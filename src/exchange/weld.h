#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/solid/mesh.h"

struct aiScene;

namespace fusee::exchange {

/// Gives corners with the same coordinates (single precision, bit by bit, -0 = 0) the same point, in order of first appearance.
class Welder {
public:
    [[nodiscard]] std::uint32_t index(std::array<float, 3> p) {
        for (float& x : p) x += 0.0f;  // -0 becomes 0
        if (2 * mesh_.points_mm.size() >= slots_.size()) widen();
        std::uint32_t& slot = slot_of(p);
        if (slot == kEmpty) {
            slot = static_cast<std::uint32_t>(mesh_.points_mm.size());
            mesh_.points_mm.push_back({p[0], p[1], p[2]});
        }
        return slot;
    }
    [[nodiscard]] solid::Mesh& mesh() { return mesh_; }

private:
    static constexpr std::uint32_t kEmpty = 0xffffffffU;

    /// The slot of this point, or an empty one: the next from its hash.
    [[nodiscard]] std::uint32_t& slot_of(const std::array<float, 3>& p) {
        const auto bits = std::bit_cast<std::array<std::uint32_t, 3>>(p);
        std::uint64_t hash = bits[0] * std::uint64_t{0x9e3779b97f4a7c15} + bits[1];
        hash = (hash ^ hash >> 29U) * std::uint64_t{0xbf58476d1ce4e5b9} + bits[2];
        hash = (hash ^ hash >> 32U) * std::uint64_t{0x94d049bb133111eb};
        for (std::size_t i = hash >> 20U;; ++i) {
            std::uint32_t& slot = slots_[i & (slots_.size() - 1)];
            if (slot == kEmpty || mesh_.points_mm[slot] == solid::Vec3{p[0], p[1], p[2]}) return slot;
        }
    }
    void widen() {
        slots_.assign(std::max<std::size_t>(1024, 4 * slots_.size()), kEmpty);
        for (std::uint32_t i = 0; i < mesh_.points_mm.size(); ++i) {
            const solid::Vec3& p = mesh_.points_mm[i];
            slot_of({static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])}) = i;
        }
    }

    std::vector<std::uint32_t> slots_;  ///< numbers of points; at most half are taken
    solid::Mesh mesh_;
};

/// The mesh that assimp reads from the bytes of one file; it opens no file. @param format the ending: "stl" @throws core::IoError
[[nodiscard]] solid::Mesh mesh_by_assimp(const std::string& bytes, const char* format, const std::filesystem::path& path);

/// All triangles of a scene of assimp; corners with the same coordinates become one point. @throws IoError if a face is not a triangle
[[nodiscard]] solid::Mesh welded(const aiScene& scene, const std::filesystem::path& path);

}  // namespace fusee::exchange
