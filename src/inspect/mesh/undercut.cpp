#include "fusee/core/parallel.h"
#include "measure.h"

namespace fusee::inspect {

namespace {

constexpr double kLift_mm = 0.01;                   // rays towards the tool start this far above the surface
constexpr double kSlack = core::rad_from_deg(1.0);  // facets of a vertical face are slightly inclined
constexpr int kTurns = 36;                          // directions of a tool around the fourth axis

std::vector<Vec3> tools(const checks::Process& process) {
    std::vector<Vec3> all{{0, 0, 1}, {0, 0, -1}};
    for (int i = 0; process.kind == checks::ProcessKind::kMill4 && i < kTurns; ++i)
        all.push_back({std::cos(2.0 * core::kPi * i / kTurns), std::sin(2.0 * core::kPi * i / kTurns), 0.0});
    return all;
}

bool is_seen(const Body& body, const Sample& s, const std::vector<Vec3>& directions) {
    const Vec3& n = body.normals()[s.triangle];
    for (const Vec3& d : directions)
        if (dot(n, d) > -std::sin(kSlack) && !body.rays().first(s.at_mm + kLift_mm * n, d, s.triangle)) return true;
    return false;
}

std::optional<Marked> measure_mesh_undercut(const Foreign& part, const Allowed& allowed) {
    if (!is_milled(part.process)) return std::nullopt;
    const Body& body = part.body;
    const std::vector<Vec3> directions = tools(part.process);
    std::vector<char> seen(body.samples().size());
    core::parallel_for(seen.size(), body.jobs(), [&](std::size_t i) { seen[i] = is_seen(body, body.samples()[i], directions) ? 1 : 0; });
    double hidden = 0.0, whole = 0.0;
    const Sample* first = nullptr;
    std::vector<std::uint32_t> triangles;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const Sample& s = body.samples()[i];
        whole += s.share_mm2;
        if (seen[i] || body.cavity()[body.topology().component_of[s.triangle]]) continue;  // mesh.cavity reports cavities
        hidden += s.share_mm2;
        if (!first) first = &s;
        if (triangles.empty() || triangles.back() != s.triangle) triangles.push_back(s.triangle);
    }
    core::Finding f = compare(100.0 * hidden / whole, {allowed("required")});
    f.what = part.process.kind == checks::ProcessKind::kMill
                 ? fmt::format("share of the surface that a tool along z reaches from neither side: {:.3g} mm^2", hidden)
                 : fmt::format("share of the surface that a tool reaches neither along z nor across it: {:.3g} mm^2", hidden);
    if (first) set_place(f, first->at_mm);
    f.suggestion = part.process.kind == checks::ProcessKind::kMill
                       ? fmt::format("{} mm^2 opened towards +z or -z, a fourth axis, or stacked plates", up(hidden))
                       : fmt::format("{} mm^2 opened towards z or outward", up(hidden));
    return Marked{f, triangles};
}

}  // namespace

Rule mesh_undercut() {
    return {{"mesh.undercut",
             "an undercut, which no tool reaches",
             "milled: share of the surface that is visible neither from +z nor from -z; mill4: nor from any of 36 directions across z",
             "sampling and rounding cause up to 0.5 % (practice)",
             {required(kAtMost, "%", 0.5)}},
            measure_mesh_undercut};
}

}  // namespace fusee::inspect
