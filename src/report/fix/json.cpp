#include "data/json.h"

#include "fusee/report/search.h"

namespace fusee::report {

namespace {

const char* end_text(Fix::End end) {
    switch (end) {
        case Fix::End::kNothingToDo:
            return "nothing to do";
        case Fix::End::kFixed:
            return "fixed";
        case Fix::End::kShortened:
            return "shortened";
        case Fix::End::kCannot:
            return "cannot be met";
    }
    return "";
}

Json one_finding_json(const core::Finding& finding) { return findings_json({finding}).front(); }

Json change_json(const MadeChange& c) {
    return {{"key", c.key},        {"from", c.was}, {"to", c.value}, {"asks_for", c.asks_for}, {"because", one_finding_json(c.because)},
            {"follows", c.follows}};
}

Json conflict_json(const FixConflict& c) {
    return {{"one", one_finding_json(c.one)},
            {"other", one_finding_json(c.other)},
            {"key", c.change.key},
            {"from", c.change.was},
            {"to", c.change.value},
            {"asks", c.asks}};
}

Json lost_torque_json(const LostTorque& l) {
    return {{"key", l.key}, {"from_Nm", l.from}, {"to_Nm", l.to}, {"lost_Nm", l.lost()}, {"binds", one_finding_json(l.binds)}};
}

Json width_or_null(const std::optional<double>& band) { return band ? Json(*band) : Json(); }

}  // namespace

std::string fix_json(const Fix& fix) {
    return json_text({{"profile", fix.profile_name},
                      {"end", end_text(fix.end)},
                      {"ended", fix.ended},
                      {"file", fix.file.string()},
                      {"changes", json_list(fix.changes, change_json)},
                      {"lost", json_list(fix.lost, lost_torque_json)},
                      {"left", findings_json(fix.left)},
                      {"conflicts", json_list(fix.conflicts, conflict_json)},
                      {"unchanged", fix.unchanged},
                      {"not_judged", fix.not_judged},
                      {"circles", fix.circles},
                      {"judged", fix.judged},
                      {"made", fix.made},
                      {"peak_torque_Nm", fix.peak_torque},
                      {"dead_band_before_rad", width_or_null(fix.band_before)},
                      {"dead_band_after_rad", width_or_null(fix.band_after)}});
}

}  // namespace fusee::report
