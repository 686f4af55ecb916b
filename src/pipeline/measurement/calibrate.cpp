#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/coupons.h"
#include "fusee/profile/edit.h"

namespace fs = std::filesystem;

namespace fusee::pipeline {

namespace {

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
