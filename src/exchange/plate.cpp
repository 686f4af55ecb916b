#include "file_entry.h"
#include "fusee/core/file.h"

namespace fusee::exchange {

solid::Mesh placed(const solid::Mesh& mesh, const PlateObject& place) {
    solid::Mesh moved = mesh;
    for (solid::Vec3& p : moved.points_mm) {
        if (place.flipped) p = {p[0], -p[1], -p[2]};
        if (place.turned) p = {-p[1], p[0], p[2]};
        for (std::size_t i = 0; i < 3; ++i) p[i] += place.moved_mm[i];
    }
    return moved;
}

solid::Mesh taken_back(const solid::Mesh& mesh, const PlateObject& place) {
    solid::Mesh back = mesh;
    for (solid::Vec3& p : back.points_mm) {
        for (std::size_t i = 0; i < 3; ++i) p[i] -= place.moved_mm[i];
        if (place.turned) p = {p[1], -p[0], p[2]};
        if (place.flipped) p = {p[0], -p[1], -p[2]};
    }
    return back;
}

void write_plate_file(const std::filesystem::path& path, const Plate& plate) {
    Json objects = Json::array();
    for (const PlateObject& o : plate.objects)
        objects.push_back(
            {{"name", o.name}, {"flipped_deg", o.flipped ? 180 : 0}, {"turned_deg", o.turned ? 90 : 0}, {"moved_mm", o.moved_mm}});
    const Json json{{"provenance", plate.provenance},
                    {"build_mm", plate.build_mm},
                    {"spacing_mm", plate.spacing_mm},
                    {"file", entry_json(plate.file)},
                    {"objects", std::move(objects)}};
    core::write_file(path, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

Plate read_plate_file(const std::filesystem::path& path) {
    const Json json = core::read_json(path);
    const JsonNode root = JsonNode::of_file(json, path.string());
    Plate plate;
    plate.provenance = root["provenance"].text();
    plate.build_mm = root["build_mm"].vector<3>();
    plate.spacing_mm = root["spacing_mm"].number_at_least(0.0);
    plate.file = read_entry(root["file"]);
    for (const JsonNode& object : root["objects"].cells(1)) {
        const JsonNode turned = object["turned_deg"], flipped = object["flipped_deg"];
        if (turned.number() != 0.0 && turned.number() != 90.0) turned.refuse("0 or 90");
        if (flipped.number() != 0.0 && flipped.number() != 180.0) flipped.refuse("0 or 180");
        plate.objects.push_back(
            {object["name"].text(), turned.number() == 90.0, object["moved_mm"].vector<3>(), flipped.number() == 180.0});
    }
    return plate;
}

}  // namespace fusee::exchange
