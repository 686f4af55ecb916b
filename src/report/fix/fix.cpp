#include <fmt/format.h>

#include <algorithm>

#include "data/figures.h"
#include "data/json.h"
#include "fusee/core/units.h"
#include "fusee/report/search.h"

namespace fusee::report {

namespace {

using End = Fix::End;

constexpr std::size_t kMostCircles = 5, kMostConflicts = 3;  // shown on a terminal

/// "rule: what: measured 3, allowed at least 4 (where)"; its suggestion was followed and is left out.
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
        return fmt::format("  the law is unchanged: dead-band at {:g} Nm {}\n", fix.peak_torque, band_text(fix.band_after));
    return fmt::format("  dead-band at {:g} Nm: {} -> {}\n", fix.peak_torque, band_text(fix.band_before), band_text(fix.band_after));
}

std::string lost_text(const LostTorque& lost) {
    return fmt::format("  {} {:g} -> {:g}: {:.3g} Nm lost; binds: {}\n", lost.key, lost.from, lost.to, lost.lost(), reason(lost.binds));
}

std::string change_text(const MadeChange& change) {
    if (!change.follows.empty())
        return fmt::format("  {} = {} (was {}): follows {}\n", change.key, change.value, change.was, change.follows);
    return fmt::format("  {} = {} (was {}): {}\n      {}\n", change.key, change.value, change.was, change.asks_for, reason(change.because));
}

/// "cam.convexity (k_se at 3.2 Nm): measured -4.13 mm, allowed at least 0 mm"
std::string limit_text(core::Finding finding) {
    const std::string rule = finding.rule, where = finding.where;
    finding.suggestion.clear(), finding.where.clear(), finding.what.clear();
    const std::string line = core::to_line(finding);
    return fmt::format("{}{}: {}", rule, where.empty() ? "" : fmt::format(" ({})", where), line.substr(line.find(": : ") + 4));
}

std::string conflict_text(const FixConflict& c) {
    const std::string asks = c.asks.empty() ? "" : fmt::format("; this rule needs {} = {}", c.change.key, c.asks);
    return fmt::format("    {}\n      needs {} = {} (was {})\n      which breaks {}{}\n", limit_text(c.one), c.change.key, c.change.value,
                       c.change.was, limit_text(c.other), asks);
}

/// Suggestions that were not followed, and why.
std::string unchanged_text(const Fix& fix) {
    std::string text;
    for (const std::string& line : fix.unchanged) text += fmt::format("  not changed: {}\n", line);
    return text;
}

std::string not_judged_line(const Fix& fix) {
    if (fix.not_judged == 0) return {};
    return fmt::format("  {} not judged: `fusee make` lists the missing data\n", counted(fix.not_judged, "rule"));
}

std::string cannot_text(const Fix& fix) {
    std::string text = fix.changes.empty() ? "  errors of the profile:\n" : "  nearest design found:\n";
    for (const MadeChange& change : fix.changes) text += change_text(change);
    if (!fix.changes.empty()) text += "  remaining errors:\n";
    for (const core::Finding& finding : fix.left) text += fmt::format("  {}\n", core::to_line(finding));
    text += unchanged_text(fix);
    if (!fix.conflicts.empty()) text += "  conflicting limits:\n";
    for (std::size_t i = 0; i < std::min(kMostConflicts, fix.conflicts.size()); ++i) text += conflict_text(fix.conflicts[i]);
    if (!fix.conflicts.empty()) return text;
    for (std::size_t i = 0; i < std::min(kMostCircles, fix.circles.size()); ++i) text += fmt::format("  cycle: {}\n", fix.circles[i]);
    return text;
}

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

std::string fix_text(const Fix& fix) {
    const std::string tried =
        fmt::format("{} judged, {} made with every file", counted(static_cast<std::size_t>(fix.judged), "profile"), fix.made);
    if (fix.end == End::kNothingToDo)
        return fmt::format("{}: can be made as it is; nothing was changed ({})\n{}", fix.profile_name, tried, not_judged_line(fix));
    if (fix.end == End::kCannot)
        return fmt::format("{}: {} ({})\n{}", fix.profile_name,
                           fix.ended.empty() ? "no combination of the suggested changes can be made"
                                             : "not fixed, and not every combination was tried: " + fix.ended,
                           tried, cannot_text(fix));
    const auto own = std::count_if(fix.changes.begin(), fix.changes.end(), [](const MadeChange& c) { return c.follows.empty(); });
    const char* how = fix.end == End::kShortened ? "not over its whole law; over part of it, it can be made with" : "fixed by";
    std::string text = fmt::format("{}: {} {} ({})\n", fix.profile_name, how, counted(static_cast<std::size_t>(own), "change"), tried);
    for (const MadeChange& change : fix.changes) text += change_text(change);
    for (const LostTorque& l : fix.lost) text += lost_text(l);
    text += unchanged_text(fix);
    text += band_line(fix);
    if (!fix.left.empty()) text += fmt::format("  {} to review and accept: `fusee make` lists them\n", counted(fix.left.size(), "warning"));
    return text + not_judged_line(fix) + fmt::format("written: {}\n", fix.file.string());
}

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
