#include "fusee/pipeline/export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compensated.h"
#include "design/words.h"
#include "fusee/cam/certificate.h"
#include "fusee/cam/mirror.h"
#include "fusee/core/lists.h"
#include "fusee/core/units.h"
#include "fusee/exchange/brep.h"
#include "fusee/exchange/part_file.h"
#include "fusee/solid/part.h"
#include "judge.h"

namespace fusee::pipeline {

namespace {

/// No arm is off by more than the mesh's chordal error: the suggested error suits the least arm. If no cable can be laid at all, the guide
/// lies within the part.
core::Suggestion nearest_change(const readback::ArmError& error, const cam::Cam& cam) {
    double least = cam.working.front().path.h, farthest = 0.0;
    for (const cam::Contact& c : cam.working)
        least = std::min(least, c.path.h), farthest = std::max(farthest, std::hypot(c.path.h, c.path.slope));
    if (std::isfinite(error.worst_relative))
        return core::change("tolerances.chordal_error_mm", core::number(0.8 * error.allowed * core::mm_from_m(least), 2));
    const cam::Guide& guide = cam.options.guide;
    const double outside = core::mm_from_m(farthest + guide.radius + 2.0 * cam.options.cable_diameter);
    return core::change(std::string(to_string(cam.kind)) + ".guide.distance_mm", fmt::format("{:.1f}", outside))
        .noted(": the guide lies within the part");
}

/// Every format that the profile asks for, PART.json with the files that carry the law, and the files compensated for the process.
fs::path write_files(PartExport& out, const profile::Profile& profile) {
    formats::write_formats(out, profile.outputs.formats);
    judge_for_mill(out, profile);
    auto entries = core::each<exchange::FileEntry>(out.law_files, &FileRow::entry);
    const fs::path json = out.path(".json");
    exchange::write_part_file(json, out.described(entries));
    out.other_files.push_back(file_row(json));
    write_compensated(out, profile);
    return json;
}

PartReport begun(const std::shared_ptr<const DesignedPart>& designed, const spring::BaseSpring& spring) {
    PartReport report;
    report.part = {designed, &designed->part};
    report.spring = spring;
    report.findings = designed->findings;
    return report;
}

void set_certificate(PartReport& report, cam::Certificate certificate) {
    report.certificate = std::move(certificate);
    if (const auto doubt = cam::doubt(report.certificate, report.part->cam.kind)) report.findings.push_back(*doubt);
}

/// One side that was written and read back.
struct Side {
    ExportedPart done;
    exchange::PartFile file;
};

/// @param designed the part of `out` @param agonist of which `out` is the mirror image: nothing is computed twice. Null: `out` is the
/// agonist
Side exported(PartExport& out, const profile::Profile& profile, const std::shared_ptr<const DesignedPart>& designed, const Side* agonist) {
    const fs::path json = write_files(out, profile);
    Side side{{out.name(), agonist != nullptr, {}, out.mesh, out.exact}, exchange::read_part_file(json)};
    PartReport& report = side.done.report;
    report = begun(designed, out.spring);
    report.name = out.name();
    report.shaft = out.shaft;
    core::append(report.findings, out.findings);
    report.arm_errors = agonist ? formats::read_back_image(json.parent_path(), side.file, {agonist->file, agonist->done.report.arm_errors})
                                : formats::read_back(json.parent_path(), side.file);
    for (const readback::ArmError& error : report.arm_errors)
        report.findings.push_back(error.when_broken == core::Severity::kError ? judge_arm(error, out.part.cam)
                                                                              : judge_print(error, out.part));
    set_certificate(report, agonist ? cam::mirrored(agonist->done.report.certificate, out.part.cam) : cam::certify(out.part.cam));
    report.files = out.law_files;
    report.files.insert(report.files.end(), out.other_files.begin(), out.other_files.end());
    report.quality = agonist ? agonist->done.report.quality : solid::measure_quality(out.part.mesh);
    return side;
}

/// The other side's export. Its bodies are mirrored from this side: neither mesh nor exact solid is made twice.
PartExport other_side(const PartExport& out, const solid::Part& part) {
    PartExport other{part, mirrored(out.spring), out.settings, out.provenance, out.path("_mirrored"), solid::mirrored(out.mesh)};
    other.provenance.options += ", mirrored";
    if (!out.exact) return other;
    const auto solid = exchange::brep::mirrored(*out.exact);
    if (solid)
        other.exact = *solid;
    else
        for (core::Finding f : solid.refusal()) {
            f.where = other.name();
            other.findings.push_back(std::move(f));
        }
    return other;
}

}  // namespace

core::Finding judge_arm(const readback::ArmError& error, const cam::Cam& cam) {
    core::Finding f;
    f.rule = "readback.arm";
    f.what = fmt::format("the lever arm recomputed from {} (read by {}{}) must be the nominal one", error.file, error.reader,
                         error.mirror_of.empty() ? "" : " in " + error.mirror_of + ", whose mirror image it is");
    f.measured = 100.0 * error.worst_relative;
    f.bound = core::Bound::kAtMost;
    f.allowed = 100.0 * error.allowed;
    f.unit = "%";
    f.where = fmt::format("{} at cam angle {:.1f} deg, worst of {} positions", to_string(cam.kind),
                          core::deg_from_rad(error.worst_angle_rad), error.rows);
    f.suggestion = nearest_change(error, cam);
    f.source = "docs/part-file.md: turn the part, lay a taut cable over the groove's floor";
    return core::judged(f, core::Severity::kError);
}

const char* to_string(Via via) { return via == Via::kCgal ? "cgal" : "openscad"; }

PartReport without_files(const std::shared_ptr<const DesignedPart>& designed, const spring::BaseSpring& spring) {
    PartReport report = begun(designed, spring);
    set_certificate(report, cam::certify(report.part->cam));
    return report;
}

std::vector<ExportedPart> export_pair(const Pair& pair, const profile::Profile& profile, const core::Provenance& provenance, Via via,
                                      const fs::path& folder, const std::optional<OnShaft>& shaft) {
    const solid::Part& part = pair.agonist->part;
    const formats::Settings settings{profile.name, profile.cable, profile.process, profile.machining, profile.outputs.kerf, profile.title};
    PartExport out{part, profile.part(part.cam.kind).spring, settings, provenance, folder / profile.name_of(part.cam.kind)};
    out.shaft = shaft;
    out.mesh = via == Via::kOpenScad ? formats::rendered_by_openscad(out) : part.mesh;
    Side agonist = exported(out, profile, pair.agonist, nullptr);
    std::vector<ExportedPart> sides;
    if (pair.antagonist && !core::any_error(agonist.done.report.findings)) {  // else the part is refused already
        PartExport other = other_side(out, pair.antagonist->part);
        sides.push_back(exported(other, profile, pair.antagonist, &agonist).done);
    }
    sides.insert(sides.begin(), std::move(agonist.done));
    for (ExportedPart& side : sides) side.report.findings = in_words_of(profile, std::move(side.report.findings));
    return sides;
}

}  // namespace fusee::pipeline
