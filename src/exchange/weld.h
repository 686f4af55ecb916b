#pragma once
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <unordered_map>

#include "fusee/solid/mesh.h"

struct aiScene;

namespace fusee::exchange {

/// Gives corners with the same coordinates (single precision, bit by bit, -0 = 0) the same point, in order of first appearance.
class Welder {
public:
    [[nodiscard]] std::uint32_t index(std::array<float, 3> p) {
        Key key{};
        for (float& x : p) x += 0.0f;  // -0 becomes 0
        std::memcpy(key.data(), p.data(), sizeof key);
        const auto [found, fresh] = index_.try_emplace(key, static_cast<std::uint32_t>(mesh_.points_mm.size()));
        if (fresh) mesh_.points_mm.push_back({p[0], p[1], p[2]});
        return found->second;
    }
    [[nodiscard]] solid::Mesh& mesh() { return mesh_; }

private:
    using Key = std::array<std::uint32_t, 3>;
    struct Hash {
        std::size_t operator()(const Key& k) const {
            return (k[0] * std::size_t{73856093}) ^ (k[1] * std::size_t{19349663}) ^ (k[2] * std::size_t{83492791});
        }
    };
    std::unordered_map<Key, std::uint32_t, Hash> index_;
    solid::Mesh mesh_;
};

/// The mesh that assimp reads from the bytes of one file; it opens no file. @param format the ending: "stl" @throws core::IoError
[[nodiscard]] solid::Mesh mesh_by_assimp(const std::string& bytes, const char* format, const std::filesystem::path& path);

/// All triangles of a scene of assimp; corners with the same coordinates become one point. @throws IoError if a face is not a triangle
[[nodiscard]] solid::Mesh welded(const aiScene& scene, const std::filesystem::path& path);

}  // namespace fusee::exchange
