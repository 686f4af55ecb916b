#include <fmt/format.h>

#include <cmath>

#include "diagnosis/page.h"
#include "diagnosis/words.h"
#include "fusee/report/redesign.h"
#include "page/column.h"
#include "page/svg_plot.h"

namespace fusee::report {

namespace {

/// 0.0312 is "3.1 %"; what is left by rounding is not told.
std::string off(double share) {
    constexpr double kRounding = 1e-5;
    if (!std::isfinite(share)) return known(share);
    return share < kRounding ? "less than 0.001 %" : fmt::format("{:.2g} %", 100.0 * share);
}

std::vector<double> degrees(const std::vector<RedesignLevel>& levels, DeadBandWidths RedesignLevel::*which) {
    std::vector<double> all;
    for (const RedesignLevel& level : levels) all.push_back(core::deg_from_rad((level.*which).measured_width));
    return all;
}

std::string chart(const Redesign& redesign) {
    std::vector<double> tau;
    for (const RedesignLevel& level : redesign.levels) tau.push_back(level.tau);
    Plot plot("Dead-band as a push-and-release test reads it", "co-contraction [Nm]", "dead-band [deg]");
    plot.curve("promised", tau, degrees(redesign.levels, &RedesignLevel::promised), "sum", true);
    plot.curve("rig as it is, old cams", tau, degrees(redesign.levels, &RedesignLevel::old_cams), "pe");
    plot.curve("rig as it is, new cams", tau, degrees(redesign.levels, &RedesignLevel::new_cams), "se");
    return "<div class=\"grid\">" + plot.from_zero().svg() + "</div>";
}

std::string widths_table(const Redesign& redesign) {
    std::vector<std::vector<Cell>> rows;
    const auto cell = [](double radians) { return Cell{known(core::deg_from_rad(radians)), "num"}; };
    for (const RedesignLevel& level : redesign.levels)
        rows.push_back({{known(level.tau), "num"},
                        cell(level.promised.measured_width),
                        cell(level.old_cams.measured_width),
                        cell(level.new_cams.measured_width),
                        cell(level.promised.exact_width),
                        cell(level.old_cams.exact_width),
                        cell(level.new_cams.exact_width)});
    return "<div class=\"dense\">" +
           html_table({"co-contraction [Nm]", "promised [deg]", "old cams", "new cams", "extreme, promised", "extreme, old cams",
                       "extreme, new cams"},
                      rows) +
           "</div><p>Extreme: between the outermost resting places; a dash where the springs' laws do not reach them.</p>";
}

/// "exact dead-band at peak torque, 1 Nm (as fusee make gives it): 51.3 deg promised, ..."
std::string at_peak(const Redesign& redesign) {
    const auto three = [&](double DeadBandWidths::*width) {
        const auto degrees = [&](const DeadBandWidths& widths) { return known(core::deg_from_rad(widths.*width)); };
        return fmt::format("{} deg promised, {} with the old cams, {} with new ones", degrees(redesign.peak.promised),
                           degrees(redesign.peak.old_cams), degrees(redesign.peak.new_cams));
    };
    return fmt::format("at peak torque, {:.4g} Nm: exact dead-band, as fusee make gives it, {}; read by the push-and-release test {}",
                       redesign.peak.tau, three(&DeadBandWidths::exact_width), three(&DeadBandWidths::measured_width));
}

/// "covers 0.9 to 1.31 Nm of the 0.85 to 1.5 Nm asked for: ..."
std::string coverage(const RedesignCover& cover) {
    if (!std::isfinite(cover.law_loads.width())) return "";
    const std::string limit =
        fmt::format("friction lets a capstan rest at loads from {:.3g} to {:.3g} Nm, the springs' law has those from {:.3g} to {:.3g} Nm",
                    cover.rest_loads.low, cover.rest_loads.high, cover.law_loads.low, cover.law_loads.high);
    const std::string asked = fmt::format("{:.3g} to {:.3g} Nm", cover.asked.low, cover.asked.high);
    if (cover.whole()) return fmt::format("covers all co-contractions asked for, {}", asked);
    if (!std::isfinite(cover.covered.width())) return fmt::format("covers no co-contraction of the {} asked for: {}", asked, limit);
    return fmt::format("covers co-contractions of {:.3g} to {:.3g} Nm, asked for are {}: {}", cover.covered.low, cover.covered.high, asked,
                       limit);
}

std::string profile_part(const RedesignProfile& profile) {
    std::vector<std::vector<Cell>> rows;
    for (const RedesignChange& c : profile.changes)
        rows.push_back({{escape(c.key), "code"}, {escape(c.was), "num"}, {escape(c.is), "num"}, {escape(c.why), ""}});
    std::string out =
        "<h3 class=\"held\">" + escape(profile.file.filename().string()) + "</h3>" + html_table({"key", "was", "is", "why"}, rows);
    out += profile.can_be_cut() ? "<p>fusee make can cut these cams.</p>" : "<p>fusee make is going to refuse these cams.</p>";
    if (const std::string cover = coverage(profile.cover); !cover.empty()) out += "<p>It " + escape(cover) + ".</p>";
    if (profile.findings.empty()) return out;
    out += "<ul>";
    for (const core::Finding& finding : profile.findings) out += "<li>" + escape(core::to_line(finding)) + "</li>";
    return out + "</ul>";
}

std::string summary(const Redesign& redesign) {
    return fmt::format(
        "<p>The springs of the rig as it is are off the law of their cams by at most {} with the old cams, {} with new ones. Its "
        "dead-band, as a push-and-release test reads it, is off the one promised by {} on the mean of {} levels with the old cams, {} with "
        "new ones; {}.</p>",
        off(redesign.torque_error_old), off(redesign.torque_error_new), off(redesign.off_with_old_cams()), redesign.levels.size(),
        off(redesign.off_with_new_cams()), at_peak(redesign));
}

}  // namespace

std::string redesign_section(const Redesign& redesign) {
    std::string out;
    if (!redesign.levels.empty()) out += summary(redesign) + chart(redesign) + widths_table(redesign);
    for (const RedesignProfile& profile : redesign.profiles) out += profile_part(profile);
    if (!redesign.not_mended.empty() || !redesign.remarks.empty()) {
        out += "<ul>";
        for (const NotMended& n : redesign.not_mended)
            out += "<li>" + escape(cause_name(n.cause)) + " is not mended by cams: " + escape(n.instead) + "</li>";
        for (const std::string& remark : redesign.remarks) out += "<li>" + escape(remark) + "</li>";
        out += "</ul>";
    }
    return section("Cams for the rig as it is", out);
}

std::string redesign_text(const Redesign& redesign) {
    std::string out;
    if (!redesign.levels.empty())
        out += fmt::format(
            "  dead-band off the one promised: {} with the old cams, {} with new ones, as a push-and-release test reads it, mean of {} "
            "levels; springs off their law: {}, {}\n  {}\n",
            off(redesign.off_with_old_cams()), off(redesign.off_with_new_cams()), redesign.levels.size(), off(redesign.torque_error_old),
            off(redesign.torque_error_new), at_peak(redesign));
    for (const RedesignProfile& profile : redesign.profiles) {
        const std::string whose = profile.sides == "both" ? "both sides" : "the " + profile.sides;
        out += fmt::format("  profile for {}: {}: {}\n", whose, profile.file.string(),
                           !redesign.new_cams_needed ? "the model alone changes, the cams stay"
                           : profile.can_be_cut()    ? "cut its cams by fusee make"
                                                     : "its cams cannot be cut");
        if (const std::string cover = coverage(profile.cover); !cover.empty()) out += "    " + cover + "\n";
        if (!profile.can_be_cut())
            for (const core::Finding& finding : profile.findings)
                if (finding.severity == core::Severity::kError) out += "    " + core::to_line(finding) + "\n";
    }
    for (const NotMended& n : redesign.not_mended) out += "  no cam mends " + cause_name(n.cause) + ": " + n.instead + "\n";
    for (const std::string& remark : redesign.remarks) out += "  - " + remark + "\n";
    return out;
}

}  // namespace fusee::report
