#include "fusee/pipeline/coupons.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "export/judge.h"
#include "fusee/checks/limits.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/core/units.h"
#include "fusee/coupon/bodies.h"
#include "fusee/coupon/sheet.h"
#include "fusee/exchange/part_file.h"
#include "fusee/exchange/stl.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/edit.h"

namespace fusee::pipeline {

namespace {

constexpr const char* kSheet = "COUPON.csv";

core::OutputRun run_of(const profile::Profile& profile, bool force) {
    return {.command = "coupons", .source = profile.file, .force = force, .files = {"README.md", "disc.json"}, .sheets = {kSheet}};
}

coupon::CouponOptions options_of(const profile::Profile& profile) {
    const checks::ProcessLimits limits = checks::process_limits(profile.process);
    coupon::CouponOptions options;
    options.groove = profile.k_se.solid.groove;
    options.hub = profile.k_se.solid.hub;
    options.cable_diameter = profile.cable.diameter;
    options.loaded_wall = limits.loaded_wall;
    options.detail = limits.detail;
    options.chordal_error = profile.k_se.solid.chordal_error;
    return options;
}

/// The three bodies.
struct Bodies {
    coupon::Plate plate;
    coupon::GrooveLadder ladder;
    coupon::Disc disc;
};

core::Outcome<Bodies> bodies_of(const coupon::CouponOptions& options) {
    auto plate = coupon::make_plate(options);
    if (!plate) return plate.refusal();
    auto ladder = coupon::make_groove_ladder(options);
    if (!ladder) return ladder.refusal();
    auto disc = coupon::make_disc(options);
    if (!disc) return disc.refusal();
    return Bodies{std::move(plate).value(), std::move(ladder).value(), std::move(disc).value()};
}

/// The body and axis with the largest share of the build volume.
core::Finding fits(const Bodies& bodies, const checks::Process& process) {
    const std::array<double, 3> space{process.build_x, process.build_y, process.build_z};
    core::Finding f;
    double fullest = 0.0;
    for (const auto& [name, mesh] :
         {std::pair{"bores_and_lengths", &bodies.plate.mesh}, {"groove_ladder", &bodies.ladder.mesh}, {"disc", &bodies.disc.part.mesh}}) {
        const solid::Box box = solid::bounding_box(*mesh);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double size = box.high_mm[axis] - box.low_mm[axis], allowed = core::mm_from_m(space[axis]);
            if (size / allowed <= fullest) continue;
            fullest = size / allowed;
            f.measured = size;
            f.allowed = allowed;
            f.where = fmt::format("{} along {}", name, "xyz"[axis]);
        }
    }
    f.rule = "coupon.build_volume";
    f.what = "the coupon must fit into the build volume";
    f.bound = core::Bound::kAtMost;
    f.unit = "mm";
    f.suggestion = fmt::format("process.build_mm of a machine with {:.0f} mm there, or a smaller k_se.hub.bore_mm", std::ceil(f.measured));
    f.source = "the profile's process.build_mm";
    return core::judged(f, core::Severity::kError);
}

coupon::Drawn drawn_of(const Bodies& bodies, const coupon::CouponOptions& options) {
    const coupon::Plate& plate = bodies.plate;
    coupon::Drawn drawn;
    drawn.cable_diameter_mm = core::mm_from_m(options.cable_diameter);
    drawn.disc_floor_mm = bodies.disc.floor_mm;
    drawn.shaft_mm = core::mm_from_m(options.hub.bore_diameter);
    drawn.x_mm = drawn.y_mm = {plate.width_mm, plate.length_mm};
    drawn.z_mm = {plate.plate_mm, plate.tower_mm};
    drawn.bores_mm = plate.bores_mm;
    drawn.groove_ratios = bodies.ladder.ratios;
    drawn.disc_turns = options.disc_turns;
    return drawn;
}

class Writer {
public:
    Writer(const fs::path& folder, core::Provenance provenance, Coupons& made)
        : folder_(folder), provenance_(std::move(provenance)), made_(made) {}

    void solid(const std::string& name, const solid::Mesh& mesh, double chordal_error_mm) {
        const fs::path stl = folder_ / (name + ".stl"), three_mf = folder_ / (name + ".3mf");
        exchange::write_stl(stl, mesh, provenance_.line());
        exchange::write_3mf(three_mf, mesh, name, provenance_.line());
        for (const fs::path& path : {stl, three_mf}) made_.files.push_back(file_row(path, mesh.triangles.size(), chordal_error_mm));
    }
    /// Reads the disc back and compares its arm with the stated one.
    void disc(const coupon::Disc& disc) {
        const std::size_t before = made_.files.size();
        solid("disc", disc.part.mesh, disc.part.chordal_error_mm);
        std::vector<exchange::FileEntry> entries;
        for (std::size_t i = before; i < made_.files.size(); ++i) entries.push_back(made_.files[i].entry);
        const fs::path json = folder_ / "disc.json";
        exchange::write_part_file(json, exchange::describe_part(disc.part, disc.spring, entries, provenance_));
        for (const readback::ArmError& error : formats::read_back(folder_, exchange::read_part_file(json)))
            made_.findings.push_back(judge_arm(error, disc.part.cam));
        made_.files.push_back(file_row(json));
    }
    void text(const char* name, const std::string& bytes) {
        core::write_file(folder_ / name, bytes);
        made_.files.push_back(file_row(folder_ / name));
    }

private:
    fs::path folder_;
    core::Provenance provenance_;
    Coupons& made_;
};

constexpr const char* kEnding = "-calibrated";

void require_same_cable(const profile::Profile& profile, const coupon::Sheet& sheet) {
    const double own = core::mm_from_m(profile.cable.diameter), sheets = sheet.cable_diameter_mm;
    if (sheets > 0.0 && std::abs(sheets - own) > 1e-6)
        throw core::InvalidInput(profile.place_of("cable.diameter_mm"), fmt::format("{:g}", own),
                                 fmt::format("{:g} mm as in the sheet: coupons are valid only for their own cable", sheets));
}

/// A diagnosis finds arms that are too long, including the effects of the cable's axis, of uncompensated shrinkage and of the contour's
/// offset; the disc's cable axis includes the offset of the machine that made it.
void require_none_of(const profile::Profile& profile, const std::vector<std::string>& keys, const char* measured) {
    for (const std::string& key : keys)
        if (const double radius = profile::number_of(profile, key); radius != 0.0)
            throw core::InvalidInput(profile.place_of(key), fmt::format("{:g}", core::mm_from_m(radius)),
                                     fmt::format("0: it already contains what {}, which would count twice; measure it again after "
                                                 "calibrating",
                                                 measured));
}

std::string why(const coupon::Figure& figure, const char* source) {
    const auto shown = [&figure](double value) { return fmt::format("{:.4g}", value * figure.per_unit); };
    return fmt::format("{}, {} rows ({}: {} to {}{}{})", source, figure.rows, figure.ladder ? "ladder" : "95 %", shown(figure.range.low),
                       shown(figure.range.high), figure.unit.empty() ? "" : " ", figure.unit);
}

/// @param source of the figures: "coupons"
std::string with_figures(const profile::Profile& profile, const std::string& toml, const coupon::Calibration& calibration,
                         const fs::path& file, const char* source) {
    std::vector<profile::Edit> edits;
    const bool changes = std::any_of(calibration.figures.begin(), calibration.figures.end(), [](const auto& f) { return f.changes(); });
    const bool again = profile.name.find(kEnding) != std::string::npos;  // "x-calibrated-2" too
    if (changes || !again) edits.push_back(profile::name_edit(profile, kEnding));
    for (auto f = calibration.figures.rbegin(); f != calibration.figures.rend(); ++f)  // each is inserted below its table's heading
        if (f->changes()) {
            edits.push_back(profile::number_edit(profile, f->key, f->value, why(*f, source)));
            edits.back().origin = std::string("measured, ") + source;
        }
    for (profile::Edit& edit : profile::file_edits(profile, fs::absolute(file).parent_path())) edits.push_back(std::move(edit));
    std::string text = profile::with_edits(toml, profile, edits);
    (void)profile::parse_profile(text, file);  // refuses values that no profile may have
    return text;
}

}  // namespace

Coupons make_coupons(const profile::Profile& profile, const fs::path& out, bool force) {
    require_parts(profile);
    core::OutputFolder output(out, profile.name + "-coupons", run_of(profile, force));
    const coupon::CouponOptions options = options_of(profile);
    const auto bodies = bodies_of(options);
    Coupons made;
    if (!bodies) {
        made.findings = bodies.refusal();
        return made;
    }
    made.findings.push_back(fits(*bodies, profile.process));
    if (core::any_error(made.findings)) return made;
    const core::Provenance provenance{profile.name, profile.sha256, "coupons"};
    Writer writer(output.path(), provenance, made);
    const double chord_mm = core::mm_from_m(options.chordal_error);
    writer.solid("bores_and_lengths", bodies->plate.mesh, chord_mm);
    writer.solid("groove_ladder", bodies->ladder.mesh, chord_mm);
    writer.disc(bodies->disc);
    const coupon::Drawn drawn = drawn_of(*bodies, options);
    writer.text(kSheet, coupon::empty_sheet(drawn, provenance.line()));
    writer.text("README.md", coupon::readme(drawn, provenance.line()));
    if (core::any_error(made.findings)) return made;
    output.commit();
    made.made = true;
    made.folder = output.target();
    return made;
}

coupon::Present present_of(const profile::Profile& profile) {
    coupon::Present present;
    for (const char* key : coupon::kShrinkKeys) present[key] = profile::number_of(profile, key);
    for (const char* key : coupon::kContourKeys) present[key] = profile::number_of(profile, key);
    for (const char* key :
         {coupon::kBoreOffsetKey, coupon::kCableAxisKey, coupon::kGrooveRatioKey, coupon::kSeriesRateKey, coupon::kParallelRateKey})
        present[key] = profile::number_of(profile, key);
    return present;
}

std::string calibrated_profile(const profile::Profile& profile, const std::string& toml, const coupon::Sheet& sheet,
                               const coupon::Calibration& calibration, const fs::path& file) {
    require_same_cable(profile, sheet);
    require_none_of(profile, {"k_se.radius_allowance_mm", "k_pe.radius_allowance_mm", coupon::kContourKeys[0], coupon::kContourKeys[1]},
                    "the coupons measure");
    return with_figures(profile, toml, calibration, file, "coupons");
}

std::string inspected_profile(const profile::Profile& profile, const std::string& toml, const coupon::InspectionSheet& sheet,
                              const coupon::Calibration& calibration, const fs::path& file) {
    const std::string part = sheet.part.substr(0, 4);
    require_none_of(profile, {part + ".radius_allowance_mm", coupon::kCableAxisKey}, "the inspection measures");
    return with_figures(profile, toml, calibration, file, "inspection");
}

}  // namespace fusee::pipeline
