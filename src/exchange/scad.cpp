#include "fusee/exchange/scad.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/process.h"
#include "fusee/core/units.h"
#include "fusee/solid/cutters.h"
#include "fusee/solid/sweep.h"
#include "templates.h"

namespace fusee::exchange {

namespace {

using core::mm_from_m;
using Values = std::map<std::string, std::string, std::less<>>;

/// The shortest digits that give the number back.
std::string number(double value) { return fmt::format("{}", value + 0.0); }

/// An OpenSCAD list with one row per line.
template <class Rows, class Print>
std::string list(const Rows& rows, Print print) {
    if (rows.empty()) return "[]";
    std::string text = "[";
    for (const auto& row : rows) text += fmt::format("{}\n    {}", text.size() > 1 ? "," : "", print(row));
    return text + "\n]";
}

/// Every column of the groove along the path: the directions of one turn, repeated for each turn of a helix.
std::vector<double> groove_columns(const solid::Part& part) {
    if (part.cam.closed()) return part.columns_psi;
    std::vector<double> columns;
    for (const double u : part.columns_psi)
        for (double psi = u; psi <= part.cam.groove_psi.high + 1e-9; psi += 2.0 * core::kPi)
            if (psi >= part.cam.groove_psi.low - 1e-9) columns.push_back(psi);
    std::sort(columns.begin(), columns.end());
    return columns;
}

void add_sweep(Values& values, const solid::Part& part) {
    const solid::Flanges flanges = solid::flanges_of(part.options);
    values["PATH"] = list(groove_columns(part), [&](double psi) {
        const cam::PathPoint p = part.cam.path(psi);
        return fmt::format("[{}, {}, {}, {}]", number(psi), number(mm_from_m(p.h)), number(mm_from_m(p.slope)), number(mm_from_m(p.z)));
    });
    values["GROOVE"] =
        list(part.section, [](const solid::SectionPoint& s) { return fmt::format("[{}, {}]", number(s.offset_mm), number(s.z_mm)); });
    values["CLOSED"] = part.cam.closed() ? "true" : "false";
    values["CHORD"] = number(0.5 * part.chordal_error_mm);
    values["CHORDAL_ERROR"] = number(part.chordal_error_mm);
    values["Z_LOW"] = number(mm_from_m(part.z_low));
    values["Z_HIGH"] = number(mm_from_m(part.z_high));
    values["RIB"] = number(mm_from_m(part.options.groove.rib));
    values["LOWER_PROUD"] = number(flanges.lower_height_mm);
    values["UPPER_PROUD"] = number(flanges.upper_height_mm);
    values["CORE_RADIUS"] = number(flanges.core_radius_mm);
    values["SKIN_POINTS"] = list(
        part.skin.points_mm, [](const solid::Vec3& p) { return fmt::format("[{}, {}, {}]", number(p[0]), number(p[1]), number(p[2])); });
    // OpenSCAD requires faces that are clockwise from outside.
    values["SKIN_FACES"] =
        list(part.skin.triangles, [](const solid::Triangle& t) { return fmt::format("[{}, {}, {}]", t[0], t[2], t[1]); });
}

void add_hub(Values& values, const solid::HubOptions& hub) {
    constexpr std::array kLocks{"plain", "keyway", "d_flat", "set_screw"};
    values["HUB_LOCK"] = kLocks.at(static_cast<std::size_t>(hub.lock));
    values["BORE_DIAMETER"] = number(mm_from_m(hub.bore_diameter));
    values["BORE_CLEARANCE"] = number(mm_from_m(hub.bore_clearance));
    values["KEY_WIDTH"] = number(mm_from_m(hub.key_width));
    values["KEY_DEPTH"] = number(mm_from_m(hub.key_depth));
    values["FLAT_DEPTH"] = number(mm_from_m(hub.flat_depth));
    values["SCREW_DIAMETER"] = number(mm_from_m(hub.screw_diameter));
    values["BOSS_DIAMETER"] = number(mm_from_m(hub.boss_diameter));
    values["BOSS_HEIGHT"] = number(mm_from_m(hub.boss_height));
    values["BLIND"] = hub.kind == solid::HubKind::kOverhung ? "true" : "false";
    values["WEB"] = number(mm_from_m(hub.web));
}

/// The positions of the cutters, as in the direct mesh.
void add_features(Values& values, const solid::Part& part) {
    const solid::FeatureOptions& f = part.options.features;
    const auto outline = solid::upper_outline(part);
    values["ANCHOR_DIAMETER"] = number(mm_from_m(f.anchor_hole_diameter));
    values["ANCHOR_POSITION"] = "[0, 0, 0]";
    values["ANCHOR_END"] = "0";
    values["DOWELS"] = "";
    values["MARK_WIDTH"] = number(mm_from_m(f.mark_width));
    values["MARK_DEPTH"] = number(mm_from_m(f.mark_depth));
    values["MARK_FROM"] = values["MARK_TO"] = "0";
    for (const solid::Cutter& c : solid::make_cutters(part)) {
        const solid::Point2& first = c.outline[0].centre_mm;
        if (c.name == "mark") {
            values["MARK_FROM"] = number(first[0]);
            values["MARK_TO"] = number(c.outline[1].centre_mm[0]);
        }
        if (c.name == "dowel")
            values["DOWELS"] +=
                fmt::format("\n    translate([{}, {}, {}]) cylinder(r = {}, h = {}, $fn = sides({}));", number(first[0]), number(first[1]),
                            number(c.low_mm), number(c.outline[0].radius_mm), number(c.high_mm - c.low_mm), number(c.outline[0].radius_mm));
        if (c.name != "anchor") continue;
        values["ANCHOR_POSITION"] = fmt::format("[{}, {}, {}]", number(first[0]), number(first[1]), number(c.low_mm));
        values["ANCHOR_END"] = number(c.high_mm);
    }
    values["LEG_SLOT_WIDTH"] = number(mm_from_m(f.leg_slot_width));
    values["LEG_SLOT_LENGTH"] = number(mm_from_m(f.leg_slot_length));
    values["LEG_SLOT_RADIUS"] = number(mm_from_m(f.leg_slot_radius));
    values["LEG_SLOT_DEPTH"] = number(mm_from_m(f.leg_slot_depth));
    values["LEG_SLOT_ANGLE"] = number(core::deg_from_rad(f.leg_slot_angle));
    const double rim = std::abs(std::min_element(outline.begin(), outline.end())->at(0));
    values["LABEL_RADIUS"] = number(0.5 * (rim + solid::bore_reach_mm(part.options.hub)));
}

/// Replaces each @NAME@ by its value. Values are not searched again: a comment may contain an @.
std::string filled(std::string_view text, const Values& values, const std::string& name) {
    std::string result;
    while (true) {
        const std::size_t begin = text.find('@'), end = begin == text.npos ? text.npos : text.find('@', begin + 1);
        result += text.substr(0, begin);
        if (begin == text.npos) return result;
        const std::string_view key = end == text.npos ? text.substr(begin + 1) : text.substr(begin + 1, end - begin - 1);
        const auto found = values.find(key);
        if (found == values.end())
            throw core::InvalidInput(name, fmt::format("@{}@", key.substr(0, 40)), fmt::format("a value of the part"));
        result += found->second;
        text.remove_prefix(end + 1);
    }
}

}  // namespace

void write_scad(const std::filesystem::path& path, const solid::Part& part, const std::string& provenance,
                const std::filesystem::path& templates) {
    const std::string name = std::string(cam::to_string(part.cam.kind)) + ".scad";
    const bool series = part.cam.kind == cam::PartKind::kSeries;
    if (!series && part.options.features.leg_slot_width > 0.0)
        throw core::InvalidInput("k_pe.features.leg_slot_width", "above 0", "0: no torsion spring");
    const auto text = [&](const char* file, std::string_view built_in) {
        return templates.empty() ? std::string(built_in) : core::read_file(templates / file);
    };
    Values values{{"PROVENANCE", provenance}};
    std::replace(values["PROVENANCE"].begin(), values["PROVENANCE"].end(), '\n', ' ');
    add_sweep(values, part);
    add_hub(values, part.options.hub);
    add_features(values, part);
    values["LIBRARY"] = filled(text("library.scad", kLibraryTemplate), values, "library.scad");
    core::write_file(path, filled(series ? text("k_se.scad", kSeriesTemplate) : text("k_pe.scad", kParallelTemplate), values, name));
}

void render_scad(const fs::path& scad, const fs::path& stl, std::chrono::seconds timeout) {
    const std::string about = scad.string();
    const fs::path temporary = stl.parent_path() / fmt::format(".{}.render-{}", stl.filename().string(), ::getpid());
    // openscad takes a file name that begins with a dash for an option.
    const auto name = [](const fs::path& p) { return fs::absolute(p).string(); };
    const core::ProcessResult result =
        core::run_process({"openscad", "--hardwarnings", "--export-format", "binstl", "-o", name(temporary), name(scad)}, about, timeout);
    std::error_code error;
    if (result.in_time && result.code == 0) {
        fs::rename(temporary, stl, error);
        if (error) throw core::IoError(stl.string(), error.message());
        return;
    }
    fs::remove(temporary, error);
    if (!result.in_time) throw core::IoError(about, fmt::format("openscad was still running after {} s", timeout.count()));
    throw core::IoError(about, fmt::format("openscad ended with {}: {}", result.code, core::last_words(result.output)));
}

}  // namespace fusee::exchange
