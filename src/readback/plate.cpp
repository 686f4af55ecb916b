#include <fmt/format.h>

#include <algorithm>

#include "compare.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/readback/readback.h"

namespace fusee::readback {

namespace {

constexpr double kRounding_mm = 1e-4;  // single precision at 1 m is 6e-5 mm

void require_within(const solid::Box& box, const exchange::NamedMesh& object, const exchange::Plate& plate, const fs::path& path) {
    for (std::size_t i = 0; i < 3; ++i)
        if (box.low_mm[i] < -kRounding_mm || box.high_mm[i] > plate.build_mm[i] + kRounding_mm)
            throw core::IoError(path.string(), fmt::format("{} extends beyond the build volume along {}", object.name, "xyz"[i]));
}

/// Is there a gap between the two along x or y?
bool apart(const solid::Box& a, const solid::Box& b, double spacing_mm) {
    const auto gap = [&](std::size_t i) { return std::max(b.low_mm[i] - a.high_mm[i], a.low_mm[i] - b.high_mm[i]); };
    return std::max(gap(0), gap(1)) >= spacing_mm - kRounding_mm;
}

void require_arranged(const std::vector<exchange::NamedMesh>& objects, const exchange::Plate& plate, const fs::path& path) {
    std::vector<solid::Box> boxes;
    for (const exchange::NamedMesh& object : objects) {
        const solid::Box box = solid::bounding_box(object.mesh);
        require_within(box, object, plate, path);
        for (std::size_t i = 0; i < boxes.size(); ++i)
            if (!apart(boxes[i], box, plate.spacing_mm))
                throw core::IoError(path.string(), fmt::format("{} and {} are nearer than {} mm to each other", objects[i].name,
                                                               object.name, plate.spacing_mm));
        boxes.push_back(box);
    }
}

void require_stated(const std::vector<exchange::NamedMesh>& objects, const exchange::Plate& plate, const fs::path& path) {
    std::size_t triangles = 0;
    for (const exchange::NamedMesh& object : objects) triangles += object.mesh.triangles.size();
    const bool same = std::equal(objects.begin(), objects.end(), plate.objects.begin(), plate.objects.end(),
                                 [](const auto& found, const auto& stated) { return found.name == stated.name; });
    if (!same || triangles != plate.file.triangles || core::sha256_hex(core::read_file(path)) != plate.file.sha256)
        throw core::IoError(path.string(), "does not have the stated objects, triangles and bytes");
}

}  // namespace

std::vector<ArmError> read_back_plate(const fs::path& folder, const exchange::Plate& plate) {
    const fs::path path = folder / plate.file.name;
    const std::vector<exchange::NamedMesh> objects = exchange::read_3mf_objects(path);
    require_stated(objects, plate, path);
    require_arranged(objects, plate, path);
    std::vector<ArmError> errors;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const exchange::PartFile part = exchange::read_part_file(folder / (objects[i].name + ".json"));
        const solid::Mesh mesh = exchange::taken_back(objects[i].mesh, plate.objects[i]);
        errors.push_back(compare(path, "lib3mf " + objects[i].name, find_floor(mesh, part), part));
    }
    return errors;
}

}  // namespace fusee::readback
