#include "fusee/exchange/part_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"

namespace fusee::exchange {

namespace {

using Json = nlohmann::ordered_json;

struct SpringKeys {
    const char *rate, *preload;
};
SpringKeys spring_keys(const std::string& kind) {
    return kind == "torsion" ? SpringKeys{"rate_Nm_per_rad", "preload_rad"} : SpringKeys{"rate_N_per_m", "preload_m"};
}

Json guide_json(const PartGuide& g) {
    if (g.kind == "parallel") return {{"kind", g.kind}, {"direction", g.direction}};
    Json json{{"kind", g.kind}, {"position_mm", g.position_mm}};
    if (g.kind == "idler") json.update({{"radius_mm", g.radius_mm}, {"sense", g.sense}});
    return json;
}

/// A value in the file that knows its own name, so that every error names file and key.
class Node {
public:
    Node(const std::filesystem::path& file, std::string key, const Json& json) : file_(file), key_(std::move(key)), json_(json) {}

    [[nodiscard]] Node at(const char* key) const {
        const std::string full = key_.empty() ? key : key_ + "." + key;
        if (!json_.is_object()) fail("must be an object");
        if (!json_.contains(key)) throw core::IoError(file_.string(), full + " is missing");
        return {file_, full, json_.at(key)};
    }
    [[nodiscard]] std::vector<Node> rows(bool may_be_empty) const {
        if (!json_.is_array()) fail("must be an array");
        if (json_.empty() && !may_be_empty) fail("must not be empty");
        std::vector<Node> nodes;
        for (std::size_t i = 0; i < json_.size(); ++i) nodes.emplace_back(file_, fmt::format("{}[{}]", key_, i), json_.at(i));
        return nodes;
    }
    [[nodiscard]] double number(double least = -HUGE_VAL) const {
        if (!json_.is_number()) fail("must be a number");
        const double value = json_.get<double>();
        if (!std::isfinite(value) || value < least) fail(fmt::format("is {}, below {}", value, least));
        return value;
    }
    [[nodiscard]] int sign() const {
        const double value = number();
        if (std::abs(value) != 1.0) fail("must be 1 or -1");
        return static_cast<int>(value);
    }
    [[nodiscard]] std::size_t count() const {
        if (!json_.is_number_unsigned()) fail("must be a whole number, at least 0");
        return json_.get<std::size_t>();
    }
    [[nodiscard]] std::string text() const {
        if (!json_.is_string() || json_.get_ref<const std::string&>().empty()) fail("must be a text that is not empty");
        return json_.get<std::string>();
    }
    [[nodiscard]] std::string one_of(std::initializer_list<std::string_view> allowed) const {
        std::string value = text();
        if (std::find(allowed.begin(), allowed.end(), value) == allowed.end())
            fail(fmt::format("is \"{}\", not one of: {}", value, fmt::join(allowed, ", ")));
        return value;
    }
    template <std::size_t N>
    [[nodiscard]] std::array<double, N> vector() const {
        const std::vector<Node> parts = rows(false);
        if (parts.size() != N) fail(fmt::format("must hold {} numbers", N));
        std::array<double, N> value{};
        for (std::size_t i = 0; i < N; ++i) value[i] = parts[i].number();
        return value;
    }
    [[noreturn]] void fail(const std::string& why) const { throw core::IoError(file_.string(), fmt::format("{} {}", key_, why)); }

private:
    std::filesystem::path file_;
    std::string key_;
    const Json& json_;
};

PartGuide read_guide(const Node& node) {
    PartGuide guide;
    guide.kind = node.at("kind").one_of({"parallel", "point", "idler"});
    if (guide.kind == "parallel") {
        guide.direction = node.at("direction").vector<2>();
        const double length = std::hypot(guide.direction[0], guide.direction[1]);
        if (std::abs(length - 1.0) > 1e-9) node.at("direction").fail("must have length 1");
        return guide;
    }
    guide.position_mm = node.at("position_mm").vector<2>();
    if (guide.kind == "idler") {
        guide.radius_mm = node.at("radius_mm").number(0.0);
        guide.sense = node.at("sense").sign();
    }
    return guide;
}

TargetRow read_row(const Node& node) {
    return {node.at("angle_rad").number(), node.at("arm_mm").number(), node.at("load").number(), node.at("contact_mm").vector<3>()};
}

FileEntry read_entry(const Node& node) {
    FileEntry entry{node.at("name").text(), node.at("sha256").text(), node.at("triangles").count(),
                    node.at("chordal_error_mm").number(0.0)};
    if (std::filesystem::path(entry.name).filename() != entry.name) node.at("name").fail("must be a file name without a folder");
    return entry;
}

PartGuide describe_guide(const cam::Guide& guide) {
    PartGuide out;
    const std::array<double, 2> towards{std::cos(guide.direction), std::sin(guide.direction)};
    const double distance = core::mm_from_m(guide.distance);
    out.direction = towards;
    out.kind = guide.kind == cam::GuideKind::kParallel ? "parallel" : guide.kind == cam::GuideKind::kPoint ? "point" : "idler";
    if (guide.kind != cam::GuideKind::kParallel) out.position_mm = {distance * towards[0], distance * towards[1]};
    if (guide.kind == cam::GuideKind::kIdler) out.radius_mm = core::mm_from_m(guide.radius);
    out.sense = guide.sense;
    return out;
}

}  // namespace

PartFile describe_part(const solid::Part& part, const spring::BaseSpring& spring, std::vector<FileEntry> files,
                       const core::Provenance& provenance) {
    PartFile out;
    out.part = cam::to_string(part.cam.kind);
    out.cable_diameter_mm = core::mm_from_m(part.cam.options.cable_diameter);
    out.rotation_sign = part.cam.rotation_sign;
    out.torque_sign = part.cam.options.torque_sign;
    out.guide = describe_guide(part.cam.options.guide);
    out.spring_kind = spring.kind == spring::BaseKind::kTorsion ? "torsion" : "compression";
    out.spring_rate = spring.rate;
    out.spring_preload = spring.preload;
    for (const cam::Contact& c : part.cam.working)
        out.target.push_back({c.arm.angle,
                              core::mm_from_m(c.arm.arm),
                              c.arm.tension,
                              {core::mm_from_m(c.path.x()), core::mm_from_m(c.path.y()), core::mm_from_m(c.path.z)}});
    out.files = std::move(files);
    out.provenance = provenance.line();
    return out;
}

void write_part_file(const std::filesystem::path& path, const PartFile& part) {
    const SpringKeys keys = spring_keys(part.spring_kind);
    Json target = Json::array(), files = Json::array();
    for (const TargetRow& r : part.target)
        target.push_back({{"angle_rad", r.angle_rad}, {"arm_mm", r.arm_mm}, {"load", r.load}, {"contact_mm", r.contact_mm}});
    for (const FileEntry& f : part.files)
        files.push_back({{"name", f.name}, {"sha256", f.sha256}, {"triangles", f.triangles}, {"chordal_error_mm", f.chordal_error_mm}});
    const Json json{{"part", part.part},
                    {"cable_diameter_mm", part.cable_diameter_mm},
                    {"rotation_sign", part.rotation_sign},
                    {"torque_sign", part.torque_sign},
                    {"guide", guide_json(part.guide)},
                    {"spring", {{"kind", part.spring_kind}, {keys.rate, part.spring_rate}, {keys.preload, part.spring_preload}}},
                    {"provenance", part.provenance},
                    {"files", std::move(files)},
                    {"target", std::move(target)}};
    core::write_file(path, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

PartFile read_part_file(const std::filesystem::path& path) {
    const Json json = Json::parse(core::read_file(path), nullptr, false);
    if (json.is_discarded()) throw core::IoError(path.string(), "is not JSON");
    const Node root(path, "", json);
    PartFile part;
    part.part = root.at("part").one_of({"k_se", "k_pe"});
    part.cable_diameter_mm = root.at("cable_diameter_mm").number(0.0);
    part.rotation_sign = root.at("rotation_sign").sign();
    part.torque_sign = root.at("torque_sign").sign();
    part.guide = read_guide(root.at("guide"));
    const Node spring = root.at("spring");
    part.spring_kind = spring.at("kind").one_of({"torsion", "compression"});
    const SpringKeys keys = spring_keys(part.spring_kind);
    part.spring_rate = spring.at(keys.rate).number(0.0);
    part.spring_preload = spring.at(keys.preload).number(0.0);
    for (const Node& row : root.at("target").rows(false)) part.target.push_back(read_row(row));
    for (const Node& entry : root.at("files").rows(true)) part.files.push_back(read_entry(entry));
    if (json.contains("provenance")) part.provenance = root.at("provenance").text();
    return part;
}

}  // namespace fusee::exchange
