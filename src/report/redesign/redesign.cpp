#include <fmt/format.h>

#include <cmath>

#include "data/figures.h"
#include "data/json.h"
#include "diagnosis/words.h"
#include "fusee/report/search.h"

namespace fusee::report {

namespace {

/// 0.0312 is "3.1 %"; rounding errors are "less than 0.001 %".
std::string error_text(double share) {
    constexpr double kRounding = 1e-5;
    if (!std::isfinite(share)) return number(share);
    return share < kRounding ? "less than 0.001 %" : fmt::format("{:.2g} %", 100.0 * share);
}

/// "exact dead-band at peak torque, 1 Nm: 51.3 deg by the profile, ..."
std::string at_peak(const Redesign& redesign) {
    const auto three = [&](double DeadBandWidths::*width) {
        return fmt::format("{} deg by the profile, {} with the old cams, {} with new cams", deg(redesign.peak.promised.*width, 3),
                           deg(redesign.peak.old_cams.*width, 3), deg(redesign.peak.new_cams.*width, 3));
    };
    return fmt::format("at peak torque, {:.4g} Nm: exact dead-band as in fusee make {}; measured by the push-and-release test {}",
                       redesign.peak.tau, three(&DeadBandWidths::exact_width), three(&DeadBandWidths::measured_width));
}

std::string profile_text(const Redesign& redesign, const RedesignProfile& profile) {
    std::string out =
        fmt::format("  profile for {}: {}: {}\n", profile.sides == "both" ? "both sides" : "the " + profile.sides, profile.file.string(),
                    !redesign.new_cams_needed ? "only the model changes, the cams stay"
                    : profile.can_be_cut()    ? "make its cams with fusee make"
                                              : "its cams cannot be made");
    if (const std::string cover = coverage(profile.cover); !cover.empty()) out += "    " + cover + "\n";
    for (const core::Finding& finding : profile.findings)
        if (finding.severity == core::Severity::kError) out += "    " + core::to_line(finding) + "\n";
    return out;
}

Json redesigned_profile_json(const RedesignProfile& profile) {
    return {{"file", profile.file.string()},
            {"sides", profile.sides},
            {"can_be_cut", profile.can_be_cut()},
            {"asked_Nm", range_json(profile.cover.asked)},
            {"covered_Nm", range_json(profile.cover.covered)},
            {"coverage", coverage(profile.cover)},
            {"changes", json_list(profile.changes,
                                  [](const Edit& c) {
                                      return Json{{"key", c.key}, {"was", c.was}, {"is", c.value}, {"why", c.why}};
                                  })},
            {"findings", findings_json(profile.findings)}};
}

Json widths_json(const DeadBandWidths& widths) { return {{"exact_rad", widths.exact_width}, {"measured_rad", widths.measured_width}}; }

Json redesign_level_json(const RedesignLevel& level) {
    return {{"tau_Nm", level.tau},
            {"promised", widths_json(level.promised)},
            {"old_cams", widths_json(level.old_cams)},
            {"new_cams", widths_json(level.new_cams)}};
}

}  // namespace

std::string coverage(const RedesignCover& cover) {
    if (!std::isfinite(cover.law_loads.width())) return "";
    const std::string limit = fmt::format("friction lets a capstan rest at loads of {} Nm, the law of the springs covers {} Nm",
                                          span(cover.rest_loads), span(cover.law_loads));
    if (cover.whole()) return fmt::format("covers all co-contractions in use, {} Nm", span(cover.asked));
    if (!std::isfinite(cover.covered.width()))
        return fmt::format("covers none of the co-contractions in use, {} Nm: {}", span(cover.asked), limit);
    return fmt::format("covers co-contractions of {} Nm of the {} Nm in use: {}", span(cover.covered), span(cover.asked), limit);
}

std::string redesign_text(const Redesign& redesign) {
    std::string out;
    if (!redesign.levels.empty())
        out += fmt::format(
            "  dead-band error against the profile: {} with the old cams, {} with new cams (push-and-release test, mean of {} levels); "
            "springs against their law: {}, {}\n  {}\n",
            error_text(redesign.off_with_old_cams()), error_text(redesign.off_with_new_cams()), redesign.levels.size(),
            error_text(redesign.torque_error_old), error_text(redesign.torque_error_new), at_peak(redesign));
    for (const RedesignProfile& profile : redesign.profiles) out += profile_text(redesign, profile);
    for (const NotMended& n : redesign.not_mended) out += "  cams do not correct " + cause_name(n.cause) + ": " + n.instead + "\n";
    for (const std::string& remark : redesign.remarks) out += "  - " + remark + "\n";
    return out;
}

std::string redesign_json(const Redesign& r) {
    return json_text({{"profile", r.profile_name},
                      {"case", r.case_name},
                      {"case_sha256", r.case_sha256},
                      {"new_cams_needed", r.new_cams_needed},
                      {"profiles", json_list(r.profiles, redesigned_profile_json)},
                      {"push_torque_Nm", r.push_torque},
                      {"dead_band", json_list(r.levels, redesign_level_json)},
                      {"at_peak", r.levels.empty() ? Json() : redesign_level_json(r.peak)},
                      {"off_with_old_cams", r.off_with_old_cams()},
                      {"off_with_new_cams", r.off_with_new_cams()},
                      {"torque_error_old", r.torque_error_old},
                      {"torque_error_new", r.torque_error_new},
                      {"not_mended", json_list(r.not_mended,
                                               [](const NotMended& n) {
                                                   return Json{{"id", n.cause.id}, {"side", n.cause.side}, {"instead", n.instead}};
                                               })},
                      {"remarks", r.remarks}},
                     {{"extreme_rad", "exact_rad"}, {"read_rad", "measured_rad"}});
}

}  // namespace fusee::report
