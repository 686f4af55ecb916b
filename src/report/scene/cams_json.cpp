#include <algorithm>
#include <cmath>
#include <set>

#include "fusee/checks/along.h"
#include "scene/parts.h"

namespace fusee::report {

namespace {

constexpr std::size_t kCamRows = 120;  // of a cam's table
constexpr int kAnchorSteps = 24;       // of the cable between working arc and anchor

/// Evenly spread working positions with both ends.
std::vector<const cam::Contact*> spread_rows(const cam::Cam& cam) {
    std::vector<const cam::Contact*> rows;
    const std::size_t n = std::min(kCamRows, cam.working.size());
    for (std::size_t i = 0; i < n; ++i) rows.push_back(&cam.working[n < 2 ? 0 : i * (cam.working.size() - 1) / (n - 1)]);
    return rows;
}

Json point_json(const cam::PathPoint& p) { return vector_json(1e3 * Eigen::Vector3d(p.x(), p.y(), p.z)); }

template <class Of>
Json column_json(const std::vector<const cam::Contact*>& rows, const Of& of) {
    return json_list(rows, [&](const cam::Contact* c) { return Json(of(*c)); });
}

/// The cable from the anchor to the wound end of the working arc: K_SE pays cable out, K_PE draws it in.
Json to_anchor(const cam::Cam& cam) {
    const double end = (cam.kind == cam::PartKind::kSeries ? cam.working.back() : cam.working.front()).path.psi;
    Json points = Json::array();
    for (int i = 0; i < kAnchorSteps; ++i)
        points.push_back(point_json(cam.path(cam.anchor_psi + (end - cam.anchor_psi) * i / kAnchorSteps)));
    return points;
}

const core::Finding* finding_of(const PartReport& part, const std::string& rule) {
    for (const core::Finding& f : part.findings)
        if (f.rule == rule && f.severity != core::Severity::kNotJudged) return &f;
    return nullptr;
}

Json rules_along(const PartReport& part, const std::vector<const cam::Contact*>& rows) {
    Json rules = Json::array();
    const cam::Cam& cam = part.part->cam;
    for (const checks::AlongCam& along : checks::along_cam())
        if (const core::Finding* f = finding_of(part, along.rule))
            rules.push_back({{"rule", f->rule},
                             {"unit", f->unit},
                             {"bound", f->bound == core::Bound::kAtMost ? "at most" : "at least"},
                             {"allowed", rounded(f->allowed)},
                             {"values", column_json(rows, [&](const cam::Contact& c) { return rounded(along.value(cam, c)); })}});
    return rules;
}

/// Ids of the part's rules with one value for the whole part.
Json whole_part_rules(const PartReport& part) {
    std::set<std::string> ids;
    for (const core::Finding& f : part.findings) ids.insert(f.rule);
    for (const checks::AlongCam& along : checks::along_cam()) ids.erase(along.rule);
    return ids;
}

Json cam_table_json(const PartReport& part) {
    const cam::Cam& cam = part.part->cam;
    const auto rows = spread_rows(cam);
    using C = cam::Contact;
    return {{"part", to_string(cam.kind)},
            {"angle_rad", column_json(rows, [](const C& c) { return rounded(c.arm.angle); })},
            {"arm_mm", column_json(rows, [](const C& c) { return rounded(core::mm_from_m(c.arm.arm)); })},
            {"tension_N", column_json(rows, [](const C& c) { return rounded(c.arm.tension); })},
            {"load_Nm", column_json(rows, [](const C& c) { return rounded(c.arm.tau); })},
            {"rho_mm", column_json(rows, [](const C& c) { return rounded(core::mm_from_m(c.path.rho)); })},
            {"contact_mm", column_json(rows, [](const C& c) { return point_json(c.path); })},
            {"to_anchor_mm", to_anchor(cam)},
            {"wound_end", cam.kind == cam::PartKind::kSeries ? "last" : "first"},
            {"rules", rules_along(part, rows)},
            {"rules_of_whole_part", whole_part_rules(part)}};
}

}  // namespace

double rounded(double value) { return std::round(1e5 * value) / 1e5 + 0.0; }
Json vector_json(const Eigen::Vector3d& v) { return Json::array({rounded(v.x()), rounded(v.y()), rounded(v.z())}); }

Json cam_tables_json(const DesignReport& design) { return json_list(design.parts, cam_table_json); }

}  // namespace fusee::report
