#include "fusee/report/fix.h"

#include <fmt/format.h>

#include <algorithm>

#include "fusee/core/units.h"
#include "json/json.h"

namespace fusee::report {

namespace {

using Json = nlohmann::ordered_json;
using End = Fix::End;

constexpr std::size_t kMostCircles = 5, kMostConflicts = 3;  // shown on a terminal

const char* word(End end) {
    switch (end) {
        case End::kNothingToDo:
            return "nothing to do";
        case End::kFixed:
            return "fixed";
        case End::kCannot:
            return "cannot be met";
    }
    return "";
}

std::string count(std::size_t n, const char* what) { return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s"); }

/// "rule: what: measured 3, allowed at least 4 (where)", without its suggestion: that was followed.
std::string reason(core::Finding finding) {
    finding.suggestion.clear();
    const std::string line = core::to_line(finding);
    return line.substr(line.find(": ") + 2);
}

std::string band_text(const std::optional<double>& band) {
    return band ? fmt::format("{:.1f} deg", core::deg_from_rad(*band)) : "beyond the law";
}

std::string band_line(const Fix& fix) {
    if (!fix.band_before && !fix.band_after) return {};
    if (fix.band_before == fix.band_after)
        return fmt::format("  the law is the same: dead-band at {:g} Nm {}\n", fix.peak_torque, band_text(fix.band_after));
    return fmt::format("  dead-band at {:g} Nm: {} -> {}\n", fix.peak_torque, band_text(fix.band_before), band_text(fix.band_after));
}

std::string lost_text(const LostTorque& lost) {
    return fmt::format("  {} {:g} -> {:g}: {:.3g} Nm lost; binds: {}\n", lost.key, lost.from, lost.to, lost.lost(), reason(lost.binds));
}

std::string change_text(const FixChange& change) {
    if (!change.follows.empty()) return fmt::format("  {} = {} (was {}): follows {}\n", change.key, change.to, change.from, change.follows);
    return fmt::format("  {} = {} (was {}): {}\n      {}\n", change.key, change.to, change.from, change.asks_for, reason(change.because));
}

/// "cam.convexity (k_se at 3.2 Nm): measured -4.13 mm, allowed at least 0 mm"
std::string figures(core::Finding finding) {
    const std::string rule = finding.rule, where = finding.where;
    finding.suggestion.clear(), finding.where.clear(), finding.what.clear();
    const std::string line = core::to_line(finding);
    return fmt::format("{}{}: {}", rule, where.empty() ? "" : fmt::format(" ({})", where), line.substr(line.find(": : ") + 4));
}

std::string conflict_text(const FixConflict& c) {
    const std::string asks = c.asks.empty() ? "" : fmt::format("; it asks for {} = {}", c.key, c.asks);
    return fmt::format("    for {}\n      {} = {} (was {})\n      breaks {}{}\n", figures(c.one), c.key, c.to, c.from, figures(c.other),
                       asks);
}

/// What was not done about the findings, and why.
std::string unchanged_text(const Fix& fix) {
    std::string text;
    for (const std::string& line : fix.unchanged) text += fmt::format("  not changed: {}\n", line);
    return text;
}

std::string not_judged_text(const Fix& fix) {
    if (fix.not_judged == 0) return {};
    return fmt::format("  {} not judged for want of data: `fusee make` lists what is missing\n", count(fix.not_judged, "rule"));
}

std::string cannot_text(const Fix& fix) {
    std::string text = fix.changes.empty() ? "  what the profile asks for binds:\n" : "  the nearest that was found:\n";
    for (const FixChange& change : fix.changes) text += change_text(change);
    if (!fix.changes.empty()) text += "  and still binding:\n";
    for (const core::Finding& finding : fix.left) text += fmt::format("  {}\n", core::to_line(finding));
    text += unchanged_text(fix);
    if (!fix.conflicts.empty()) text += "  limits that stand against each other:\n";
    for (std::size_t i = 0; i < std::min(kMostConflicts, fix.conflicts.size()); ++i) text += conflict_text(fix.conflicts[i]);
    if (!fix.conflicts.empty()) return text;
    for (std::size_t i = 0; i < std::min(kMostCircles, fix.circles.size()); ++i) text += fmt::format("  a circle: {}\n", fix.circles[i]);
    return text;
}

Json band_json(const std::optional<double>& band) { return band ? Json(*band) : Json(); }

}  // namespace

std::string fix_json(const Fix& fix) {
    Json changes = Json::array(), lost = Json::array(), conflicts = Json::array();
    for (const FixChange& c : fix.changes)
        changes.push_back({{"key", c.key},
                           {"from", c.from},
                           {"to", c.to},
                           {"asks_for", c.asks_for},
                           {"because", findings_json({c.because})[0]},
                           {"follows", c.follows}});
    for (const FixConflict& c : fix.conflicts)
        conflicts.push_back({{"one", findings_json({c.one})[0]},
                             {"other", findings_json({c.other})[0]},
                             {"key", c.key},
                             {"from", c.from},
                             {"to", c.to},
                             {"asks", c.asks}});
    for (const LostTorque& l : fix.lost)
        lost.push_back(
            {{"key", l.key}, {"from_Nm", l.from}, {"to_Nm", l.to}, {"lost_Nm", l.lost()}, {"binds", findings_json({l.binds})[0]}});
    const Json j{{"profile", fix.profile_name},
                 {"end", word(fix.end)},
                 {"file", fix.file.string()},
                 {"changes", std::move(changes)},
                 {"lost", std::move(lost)},
                 {"left", findings_json(fix.left)},
                 {"conflicts", std::move(conflicts)},
                 {"unchanged", fix.unchanged},
                 {"not_judged", fix.not_judged},
                 {"circles", fix.circles},
                 {"judged", fix.judged},
                 {"made", fix.made},
                 {"peak_torque_Nm", fix.peak_torque},
                 {"dead_band_before_rad", band_json(fix.band_before)},
                 {"dead_band_after_rad", band_json(fix.band_after)}};
    // A file's name may be no UTF-8.
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string fix_text(const Fix& fix) {
    const std::string tried =
        fmt::format("{} judged, {} made with every file", count(static_cast<std::size_t>(fix.judged), "profile"), fix.made);
    if (fix.end == End::kNothingToDo)
        return fmt::format("{}: no change is required; nothing was changed ({})\n{}", fix.profile_name, tried, not_judged_text(fix));
    if (fix.end == End::kCannot)
        return fmt::format("{}: cannot be met by changes that findings suggest ({})\n{}", fix.profile_name, tried, cannot_text(fix));
    const auto own = std::count_if(fix.changes.begin(), fix.changes.end(), [](const FixChange& c) { return c.follows.empty(); });
    std::string text = fmt::format("{}: fixed by {} ({})\n", fix.profile_name, count(static_cast<std::size_t>(own), "change"), tried);
    for (const FixChange& change : fix.changes) text += change_text(change);
    for (const LostTorque& l : fix.lost) text += lost_text(l);
    text += unchanged_text(fix);
    text += band_line(fix);
    if (!fix.left.empty()) text += fmt::format("  {} to review and accept: `fusee make` lists them\n", count(fix.left.size(), "finding"));
    return text + not_judged_text(fix) + fmt::format("written: {}\n", fix.file.string());
}

}  // namespace fusee::report
