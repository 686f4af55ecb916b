#include "plate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "design/words.h"
#include "fusee/checks/limits.h"
#include "fusee/checks/support.h"
#include "fusee/core/units.h"
#include "fusee/exchange/part_file.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/readback/readback.h"
#include "fusee/solid/arrange.h"
#include "judge.h"

namespace fs = std::filesystem;

namespace fusee::pipeline {

namespace {

constexpr double kSpacing_mm = 5.0;     // between skirts of neighbours (practice)
constexpr double kSupported_mm = 10.0;  // the supports' first layer reaches 4 mm beyond a part (PrusaSlicer 2.5)

/// Between neighbours on the bed.
double spacing_mm(const checks::Process& process) { return checks::process_limits(process).overhang > 0.0 ? kSupported_mm : kSpacing_mm; }

std::array<double, 3> build_mm(const checks::Process& process) {
    return {core::mm_from_m(process.build_x), core::mm_from_m(process.build_y), core::mm_from_m(process.build_z)};
}

core::Finding too_small(const std::vector<solid::Size2>& sizes, const std::array<double, 3>& build, double spacing) {
    const double factor = solid::least_bed(sizes, {build[0], build[1]}, spacing);
    const double x = std::ceil(factor * build[0]), y = std::ceil(factor * build[1]);
    core::Finding f;
    f.rule = "plate.bed";
    f.what = fmt::format("{} parts, {:g} mm apart, do not fit on one bed of {:g} x {:g} mm: plate.3mf is not written", sizes.size(),
                         spacing, build[0], build[1]);
    f.measured = x;
    f.bound = core::Bound::kAtMost;
    f.allowed = build[0];
    f.unit = "mm";
    f.where = "bed along x";
    f.suggestion = core::change("process.build_mm", fmt::format("[{:g}, {:g}, {:g}]", x, y, build[2]))
                       .or_else("print the parts one by one from their own files");
    f.source = "process.build_mm; quarter turns about z allowed";
    return core::judged(f, core::Severity::kWarning);
}

/// Printed parts stand on the side that needs less support; without a limit for overhangs, on either side.
bool stands_on_top(const ExportedPart& part, const checks::Process& process) {
    const double overhang = checks::process_limits(process).overhang;
    return overhang > 0.0 && checks::prints_on_its_top(part.mesh, overhang);
}

/// The objects as they stand, in the middle of the bed.
struct Arranged {
    std::vector<exchange::PlateObject> places;
    std::vector<exchange::NamedMesh> objects;
};
Arranged stand(const std::vector<ExportedPart>& parts, const std::vector<solid::Spot>& spots, const checks::Process& process) {
    const std::array<double, 3> build = build_mm(process);
    Arranged all;
    solid::Size2 reach{};  // of the group from the bed's corner
    for (std::size_t i = 0; i < parts.size(); ++i) {
        exchange::PlateObject place{parts[i].name, spots[i].turned, {}, stands_on_top(parts[i], process)};
        const solid::Box box = solid::bounding_box(exchange::placed(parts[i].mesh, place));
        for (std::size_t k = 0; k < 2; ++k) {
            place.moved_mm[k] = spots[i].corner_mm[k] - box.low_mm[k];
            reach[k] = std::max(reach[k], spots[i].corner_mm[k] + box.high_mm[k] - box.low_mm[k]);
        }
        place.moved_mm[2] = -box.low_mm[2];
        all.places.push_back(place);
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t k = 0; k < 2; ++k) all.places[i].moved_mm[k] += 0.5 * (build[k] - reach[k]);
        all.objects.push_back({parts[i].name, exchange::placed(parts[i].mesh, all.places[i])});
    }
    return all;
}

exchange::Plate write(const Arranged& all, const std::array<double, 3>& build, double spacing, double chordal_error_mm,
                      const std::string& provenance, const fs::path& folder, PlateFiles& out) {
    const fs::path three_mf = folder / "plate.3mf", json = folder / "plate.json";
    std::size_t triangles = 0;
    for (const exchange::NamedMesh& object : all.objects) triangles += object.mesh.triangles.size();
    exchange::write_3mf(three_mf, all.objects, provenance);
    out.files.push_back(file_row(three_mf, triangles, chordal_error_mm));
    exchange::write_plate_file(json, {out.files.front().entry, build, spacing, all.places, provenance});
    out.files.push_back(file_row(json));
    return exchange::read_plate_file(json);
}

}  // namespace

PlateFiles write_plate(const std::vector<ExportedPart>& parts, const profile::Profile& profile, const core::Provenance& provenance,
                       const fs::path& folder) {
    PlateFiles out;
    if (!profile.outputs.plate || !profile.outputs.has("3mf")) return out;
    const std::array<double, 3> build = build_mm(profile.process);
    std::vector<solid::Size2> sizes;
    double chordal_error_mm = 0.0;
    for (const ExportedPart& part : parts) {
        const solid::Box box = solid::bounding_box(part.mesh);
        sizes.push_back({box.high_mm[0] - box.low_mm[0], box.high_mm[1] - box.low_mm[1]});
        chordal_error_mm = std::max(chordal_error_mm, part.report.part->chordal_error_mm);
    }
    const double spacing = spacing_mm(profile.process);
    const auto spots = solid::arrange(sizes, {build[0], build[1]}, spacing);
    if (!spots) {
        out.findings.push_back(too_small(sizes, build, spacing));
        return out;
    }
    const exchange::Plate plate =
        write(stand(parts, *spots, profile.process), build, spacing, chordal_error_mm, provenance.line(), folder, out);
    out.arm_errors = readback::read_back_plate(folder, plate);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        core::Finding& f = out.findings.emplace_back(judge_arm(out.arm_errors[i], parts[i].report.part->cam));
        if (profile.has_two_cables())
            f.where.replace(0, std::string_view(to_string(cam::PartKind::kParallel)).size(), parts[i].report.name);
    }
    out.findings = in_words_of(profile, std::move(out.findings));
    return out;
}

}  // namespace fusee::pipeline
