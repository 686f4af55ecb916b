#include "fusee/exchange/part_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "file_entry.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "outlines.h"

namespace fusee::exchange {

namespace {

struct SpringKeys {
    const char *rate, *preload;
};
SpringKeys spring_keys(const std::string& kind) {
    return kind == "torsion" ? SpringKeys{"rate_Nm_per_rad", "preload_rad"} : SpringKeys{"rate_N_per_m", "preload_m"};
}

Json guide_json(const PartGuide& g) {
    if (g.kind == "parallel") return {{"kind", g.kind}, {"direction", g.direction}};
    if (g.kind == "roller")
        return {
            {"kind", g.kind}, {"direction", g.direction}, {"offset_mm", g.offset_mm}, {"radius_mm", g.radius_mm}, {"start_mm", g.start_mm}};
    if (g.kind == "arm")
        return {{"kind", g.kind},           {"position_mm", g.position_mm}, {"direction", g.direction}, {"sense", g.sense},
                {"radius_mm", g.radius_mm}, {"arm_mm", g.arm_mm},           {"lever_mm", g.lever_mm},   {"spring_mm", g.spring_mm}};
    Json json{{"kind", g.kind}, {"position_mm", g.position_mm}, {"z_mm", g.z_mm}};
    if (g.kind == "idler") json.update({{"radius_mm", g.radius_mm}, {"sense", g.sense}});
    return json;
}

double length_above_0(const JsonNode& node) {
    const double length = node.number();
    if (!(length > 0.0)) node.refuse("a length above 0");
    return length;
}

PartGuide read_guide(const JsonNode& node) {
    PartGuide guide;
    guide.kind = node["kind"].one_of({"parallel", "point", "idler", "roller", "arm"});
    if (guide.has_roller()) guide.radius_mm = node["radius_mm"].number_at_least(0.0);
    if (guide.kind == "roller") {
        guide.offset_mm = node["offset_mm"].number();
        guide.start_mm = node["start_mm"].number_at_least(0.0);
    }
    if (guide.kind == "arm") {
        guide.position_mm = node["position_mm"].vector<2>();
        guide.sense = node["sense"].sign();
        guide.arm_mm = length_above_0(node["arm_mm"]);
        guide.lever_mm = length_above_0(node["lever_mm"]);
        guide.spring_mm = length_above_0(node["spring_mm"]);
    }
    if (guide.kind == "parallel" || guide.has_roller()) {
        guide.direction = node["direction"].vector<2>();
        const double length = std::hypot(guide.direction[0], guide.direction[1]);
        if (std::abs(length - 1.0) > 1e-9) node["direction"].refuse("a vector of length 1");
        return guide;
    }
    guide.position_mm = node["position_mm"].vector<2>();
    guide.z_mm = node["z_mm"].number();
    if (guide.kind == "idler") {
        guide.radius_mm = node["radius_mm"].number_at_least(0.0);
        guide.sense = node["sense"].sign();
    }
    return guide;
}

TargetRow read_row(const JsonNode& node, bool roller) {
    return {node["angle_rad"].number(),
            node["arm_mm"].number(),
            node["load"].number(),
            node["contact_mm"].vector<3>(),
            roller ? node["lift_mm"].number() : 0.0,
            node.has("stretch_mm") ? node["stretch_mm"].number() : 0.0};
}

Json shaft_json(const OnShaft& s) { return {{"first_rad", s.first_rad}, {"sense", s.sense}, {"height_mm", s.height_mm}}; }

OnShaft read_shaft(const JsonNode& node) { return {node["first_rad"].number(), node["sense"].sign(), node["height_mm"].number()}; }

Json compensated_json(const Compensated& c) {
    return {{"shrink_percent", c.shrink_percent}, {"bore_offset_mm", c.bore_offset_mm}, {"bore_mm", c.bore_mm}};
}

Compensated read_compensated(const JsonNode& node) {
    return {node["shrink_percent"].vector<3>(), node["bore_offset_mm"].number(), node["bore_mm"].number_at_least(0.0)};
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
    out.z_mm = core::mm_from_m(guide.z);
    return out;
}

/// Second difference of the arms at a row; 0 at both ends.
double bend_mm(const std::vector<TargetRow>& rows, std::size_t i) {
    return i == 0 || i + 1 >= rows.size() ? 0.0 : std::abs(rows[i + 1].arm_mm - 2.0 * rows[i].arm_mm + rows[i - 1].arm_mm);
}

/// The arm of a roller is the slope of its lift: the trapezoids under the arms must give the lift. The error of a trapezoid is a twelfth of
/// its width times the second difference. It is large at the start of a spring with little preload; twice the error is allowed.
void require_lift(const std::vector<TargetRow>& rows, const JsonNode& target) {
    constexpr double kTrapezoids =
        2e-4;  // of the whole lift: the error of 200 rows for the arm with the largest second derivative of all laws
    double lift = 0.0, missed = 0.0;
    for (const TargetRow& row : rows) missed = std::max(missed, kTrapezoids * std::abs(row.lift_mm));  // a lift may fall and rise again
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double width = rows[i].angle_rad - rows[i - 1].angle_rad;
        lift += 0.5 * (rows[i].arm_mm + rows[i - 1].arm_mm) * width;
        missed += std::abs(width) * std::max(bend_mm(rows, i - 1), bend_mm(rows, i)) / 6.0;
        if (!(std::abs(rows[i].lift_mm - rows[0].lift_mm - lift) <= missed))
            target.cells()[i]["lift_mm"].refuse(fmt::format("{} mm, the integral of arm_mm over angle_rad", lift));
    }
}

PartGuide describe_arm(const cam::Roller& roller) {
    PartGuide out;
    out.kind = "arm";
    const double back =
        roller.direction - roller.arm.side * cam::arm_start(roller);  // opposite to the arm: its mirror image has it negated
    out.position_mm = arm_pivot_mm(roller);
    out.direction = {-std::cos(back), -std::sin(back)};
    out.sense = -roller.arm.side;
    out.radius_mm = core::mm_from_m(roller.radius);
    out.arm_mm = core::mm_from_m(roller.arm.length);
    out.lever_mm = core::mm_from_m(roller.arm.lever);
    out.spring_mm = core::mm_from_m(roller.arm.spring);
    return out;
}

PartGuide describe_follower(const cam::Roller& roller) {
    if (roller.follower == cam::FollowerKind::kArm) return describe_arm(roller);
    PartGuide out;
    out.kind = "roller";
    out.direction = {std::cos(roller.direction), std::sin(roller.direction)};
    out.offset_mm = core::mm_from_m(roller.offset);
    out.radius_mm = core::mm_from_m(roller.radius);
    out.start_mm = core::mm_from_m(cam::follower_start(roller));
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
    out.guide = part.cam.has_roller() ? describe_follower(part.cam.options.roller) : describe_guide(part.cam.options.guide);
    out.spring_kind = spring.kind == spring::BaseKind::kTorsion ? "torsion" : "compression";
    out.spring_rate = spring.rate;
    out.spring_preload = spring.preload;
    for (const cam::Contact& c : part.cam.working)
        out.target.push_back({c.arm.angle,
                              core::mm_from_m(c.arm.arm),
                              c.arm.tension,
                              {core::mm_from_m(c.path.x()), core::mm_from_m(c.path.y()), core::mm_from_m(c.path.z)},
                              core::mm_from_m(c.arm.travel),
                              core::mm_from_m(c.arm.elongation.length)});
    out.files = std::move(files);
    out.provenance = provenance.line();
    return out;
}

void write_part_file(const std::filesystem::path& path, const PartFile& part) {
    const SpringKeys keys = spring_keys(part.spring_kind);
    Json target = Json::array(), files = Json::array();
    for (const TargetRow& r : part.target)
        target.push_back({{"angle_rad", r.angle_rad}, {"arm_mm", r.arm_mm}, {"load", r.load}, {"contact_mm", r.contact_mm}});
    if (part.guide.has_roller())
        for (std::size_t i = 0; i < part.target.size(); ++i) target[i]["lift_mm"] = part.target[i].lift_mm;
    if (!part.target.empty() && part.target.back().stretch_mm != 0.0)
        for (std::size_t i = 0; i < part.target.size(); ++i) target[i]["stretch_mm"] = part.target[i].stretch_mm;
    for (const FileEntry& f : part.files) files.push_back(entry_json(f));
    Json json{{"part", part.part},
              {"cable_diameter_mm", part.cable_diameter_mm},
              {"rotation_sign", part.rotation_sign},
              {"torque_sign", part.torque_sign},
              {"guide", guide_json(part.guide)},
              {"spring", {{"kind", part.spring_kind}, {keys.rate, part.spring_rate}, {keys.preload, part.spring_preload}}},
              {"provenance", part.provenance},
              {"files", std::move(files)},
              {"target", std::move(target)}};
    if (part.shaft) json["shaft"] = shaft_json(*part.shaft);
    if (part.compensated) json["compensated"] = compensated_json(*part.compensated);
    core::write_file(path, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

PartFile read_part_file(const std::filesystem::path& path) {
    const Json json = core::read_json(path);
    const JsonNode root = JsonNode::of_file(json, path.string());
    PartFile part;
    part.part = root["part"].one_of({"k_se", "k_pe"});
    part.cable_diameter_mm = root["cable_diameter_mm"].number_at_least(0.0);
    part.rotation_sign = root["rotation_sign"].sign();
    part.torque_sign = root["torque_sign"].sign();
    part.guide = read_guide(root["guide"]);
    const JsonNode spring = root["spring"];
    part.spring_kind = spring["kind"].one_of({"torsion", "compression"});
    const SpringKeys keys = spring_keys(part.spring_kind);
    part.spring_rate = spring[keys.rate].number_at_least(0.0);
    part.spring_preload = spring[keys.preload].number_at_least(0.0);
    for (const JsonNode& row : root["target"].cells(1)) part.target.push_back(read_row(row, part.guide.has_roller()));
    if (part.guide.has_roller()) require_lift(part.target, root["target"]);
    for (const JsonNode& entry : root["files"].cells()) part.files.push_back(read_entry(entry));
    if (root.has("provenance")) part.provenance = root["provenance"].text();
    if (root.has("shaft")) part.shaft = read_shaft(root["shaft"]);
    if (root.has("compensated")) part.compensated = read_compensated(root["compensated"]);
    return part;
}

}  // namespace fusee::exchange
