#include "json/json.h"

#include <nlohmann/json.hpp>

#include "fusee/report/redesign.h"

namespace fusee::report {

namespace {

using Json = nlohmann::ordered_json;

Json profile_json(const RedesignProfile& profile) {
    Json changes = Json::array();
    for (const RedesignChange& c : profile.changes) changes.push_back({{"key", c.key}, {"was", c.was}, {"is", c.is}, {"why", c.why}});
    const auto range = [](const core::Range& r) { return Json::array({r.low, r.high}); };
    return {{"file", profile.file.string()},
            {"sides", profile.sides},
            {"can_be_cut", profile.can_be_cut()},
            {"asked_Nm", range(profile.cover.asked)},
            {"covered_Nm", range(profile.cover.covered)},
            {"changes", std::move(changes)},
            {"findings", findings_json(profile.findings)}};
}

Json widths_json(const DeadBandWidths& widths) { return {{"extreme_rad", widths.exact_width}, {"read_rad", widths.measured_width}}; }

Json level_json(const RedesignLevel& level) {
    return {{"tau_Nm", level.tau},
            {"promised", widths_json(level.promised)},
            {"old_cams", widths_json(level.old_cams)},
            {"new_cams", widths_json(level.new_cams)}};
}

}  // namespace

std::string redesign_json(const Redesign& r) {
    Json profiles = Json::array(), levels = Json::array(), not_mended = Json::array();
    for (const RedesignProfile& profile : r.profiles) profiles.push_back(profile_json(profile));
    for (const RedesignLevel& level : r.levels) levels.push_back(level_json(level));
    for (const NotMended& n : r.not_mended) not_mended.push_back({{"id", n.cause.id}, {"side", n.cause.side}, {"instead", n.instead}});
    const Json j{{"profile", r.profile_name},
                 {"case", r.case_name},
                 {"case_sha256", r.case_sha256},
                 {"new_cams_needed", r.new_cams_needed},
                 {"profiles", std::move(profiles)},
                 {"push_torque_Nm", r.push_torque},
                 {"dead_band", std::move(levels)},
                 {"at_peak", r.levels.empty() ? Json() : level_json(r.peak)},
                 {"off_with_old_cams", r.off_with_old_cams()},
                 {"off_with_new_cams", r.off_with_new_cams()},
                 {"torque_error_old", r.torque_error_old},
                 {"torque_error_new", r.torque_error_new},
                 {"not_mended", std::move(not_mended)},
                 {"remarks", r.remarks}};
    // A folder's name may be no UTF-8.
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fusee::report
