#include "compensated.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/checks/check.h"
#include "fusee/core/units.h"
#include "fusee/readback/readback.h"
#include "fusee/solid/part.h"
#include "fusee/solid/validity.h"

namespace fusee::pipeline {

namespace {

constexpr double kSameBore_mm = 0.005;

/// Rules that compare the bore with its shaft and key.
bool judges_fit(const std::string& rule) { return rule.starts_with("shaft.") && rule != "shaft.hub_wall"; }

core::Severity worst(const core::Findings& findings, const std::string& rule) {
    core::Severity severity = core::Severity::kPass;
    for (const core::Finding& f : findings)
        if (f.rule == rule) severity = std::max(severity, f.severity);
    return severity;
}

core::Findings of_file(core::Findings findings) {
    for (core::Finding& f : findings) f.where += ", in the compensated file";
    return findings;
}

/// "compensated, not nominal": at the front, because an STL header holds 80 bytes only.
std::string provenance_of(const PartExport& out, const solid::Compensation& c) {
    return fmt::format("compensated, not nominal: {}, shrinkage {:g} {:g} {:g} %, bore {:+g} mm", out.provenance.line(),
                       100.0 * c.shrink[0], 100.0 * c.shrink[1], 100.0 * c.shrink[2], core::mm_from_m(c.bore_offset));
}

exchange::Compensated stated(const PartExport& out, const solid::Compensation& c) {
    const solid::HubOptions& hub = out.part.options.hub;
    exchange::Compensated all;
    for (std::size_t axis = 0; axis < 3; ++axis)
        all.shrink_percent[axis] = std::round(1e11 * c.shrink[axis]) / 1e9;  // 0.46, not 0.45999999999999996
    all.bore_offset_mm = core::mm_from_m(c.bore_offset);
    all.bore_mm = core::mm_from_m(hub.bore_diameter + hub.bore_clearance);
    return all;
}

core::Finding judge_bore(const fs::path& stl, const exchange::PartFile& part) {
    core::Finding f;
    f.rule = "readback.bore";
    f.what = fmt::format("the finished bore of {} must be the drawn one", stl.filename().string());
    f.measured = std::abs(readback::bore_mm(stl, part) - part.compensated->bore_mm);
    f.bound = core::Bound::kAtMost;
    f.allowed = kSameBore_mm;
    f.unit = "mm";
    f.where = part.part;
    f.suggestion = core::change("compensation.bore_offset_mm", "0").noted(", and report this error of fusee");
    f.source = "docs/part-file.md: the file's bore minus the offset of the process";
    return core::judged(f, core::Severity::kError);
}

/// The mesh formats that the profile asks for.
std::vector<formats::Format> mesh_formats(const profile::Profile& profile) {
    std::vector<formats::Format> found;
    for (const formats::Format& format : formats::all_formats())
        if (format.write_mesh != nullptr && profile.outputs.has(format.name)) found.push_back(format);
    return found;
}

}  // namespace

core::Findings check_compensated(const solid::Part& part, const profile::Profile& profile, const core::Findings& nominal) {
    if (profile.compensation.bore_offset == 0.0) return {};
    const auto wider = solid::with_wider_bore(part, profile.compensation.bore_offset);
    if (!wider) return of_file(wider.refusal());
    const profile::PartSpec& spec = profile.part(part.cam.kind);
    core::Findings worse;
    for (const core::Finding& f : checks::check({*wider, spec.spring, profile.cable, profile.process, profile.limits}))
        if (!judges_fit(f.rule) && core::is_broken(f) && f.severity > worst(nominal, f.rule)) worse.push_back(f);
    return of_file(worse);
}

void write_compensated(PartExport& out, const profile::Profile& profile) {
    const solid::Compensation& c = profile.compensation;
    const std::vector<formats::Format> asked = mesh_formats(profile);
    if (c.none() || asked.empty()) return;
    const auto part = c.bore_offset == 0.0 ? core::Outcome<solid::Part>(out.part) : solid::with_wider_bore(out.part, c.bore_offset);
    if (!part) return core::append(out.findings, of_file(part.refusal()));
    const solid::Mesh mesh = solid::grown(part->mesh, c.shrink);
    if (const solid::Validity validity = solid::validate(mesh); !validity.good())  // scaled and rounded, faces may meet
        return out.findings.push_back(solid::invalid_solid(validity, "the compensated solid", out.name(),
                                                           "compensation.shrink_x_percent and the others rounded to 0.1"));
    exchange::PartFile file = out.described({});
    file.compensated = stated(out, c);
    file.provenance = provenance_of(out, c);
    for (const formats::Format& format : asked) {
        const fs::path path = out.path(std::string("_compensated") + format.extension);
        format.write_mesh(path, mesh, path.stem().string(), file.provenance);
        out.other_files.push_back(file_row(path, mesh.triangles.size(), out.part.chordal_error_mm));
        file.files.push_back(out.other_files.back().entry);
    }
    const fs::path json = out.path("_compensated.json");
    exchange::write_part_file(json, file);
    const exchange::PartFile read = exchange::read_part_file(json);
    for (const readback::ArmError& error : formats::read_back(json.parent_path(), read))
        out.findings.push_back(judge_arm(error, out.part.cam));
    if (profile.outputs.has("stl")) out.findings.push_back(judge_bore(out.path("_compensated.stl"), read));
    out.other_files.push_back(file_row(json));
}

}  // namespace fusee::pipeline
