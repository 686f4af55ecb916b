#include "data/json.h"

#include "fusee/report/search.h"

namespace fusee::report {

namespace {

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
