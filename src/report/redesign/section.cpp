#include <fmt/format.h>

#include <cmath>

#include "diagnosis/words.h"
#include "fusee/report/redesign.h"
#include "page/column.h"
#include "page/html.h"
#include "page/svg_plot.h"

namespace fusee::report {

namespace {

/// 0.0312 is "3.1 %"; rounding errors are "less than 0.001 %".
std::string error_text(double share) {
    constexpr double kRounding = 1e-5;
    if (!std::isfinite(share)) return number(share);
    return share < kRounding ? "less than 0.001 %" : fmt::format("{:.2g} %", 100.0 * share);
}

std::string redesign_chart(const Redesign& redesign) {
    const std::vector<double> tau = column(redesign.levels, &RedesignLevel::tau);
    const auto degrees = [&](DeadBandWidths RedesignLevel::*which) {
        return column(redesign.levels, [=](const RedesignLevel& level) { return deg_from_rad((level.*which).measured_width); });
    };
    Plot plot("Dead-band as a push-and-release test measures it", "co-contraction [Nm]", "dead-band [deg]");
    plot.curve("profile", tau, degrees(&RedesignLevel::promised), "sum", true);
    plot.curve("rig as diagnosed, old cams", tau, degrees(&RedesignLevel::old_cams), "pe");
    plot.curve("rig as diagnosed, new cams", tau, degrees(&RedesignLevel::new_cams), "se");
    return grid(plot.from_zero().svg());
}

std::string widths_table(const Redesign& redesign) {
    Rows rows;
    for (const RedesignLevel& level : redesign.levels) {
        std::vector<Cell>& row = rows.emplace_back(std::vector<Cell>{num(level.tau, 3)});
        for (const auto figure : {&DeadBandWidths::measured_width, &DeadBandWidths::exact_width})
            for (const DeadBandWidths* widths : {&level.promised, &level.old_cams, &level.new_cams})
                row.push_back(num(deg(widths->*figure, 3)));
    }
    return dense_table(
               "Dead-bands of the profile, of the old and of the new cams",
               {"co-contraction [Nm]", "measured, profile [deg]", "old cams", "new cams", "exact, profile [deg]", "old cams", "new cams"},
               rows) +
           paragraph(
               "Measured: by a push-and-release test. Exact: between the outermost resting places; a dash where the laws of the springs "
               "do not reach them.");
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

/// "covers 0.9 to 1.31 Nm of the 0.85 to 1.5 Nm asked for: ..."
std::string coverage(const RedesignCover& cover) {
    if (!std::isfinite(cover.law_loads.width())) return "";
    const std::string limit = fmt::format("friction lets a capstan rest at loads of {} Nm, the law of the springs covers {} Nm",
                                          span(cover.rest_loads), span(cover.law_loads));
    if (cover.whole()) return fmt::format("covers all co-contractions in use, {} Nm", span(cover.asked));
    if (!std::isfinite(cover.covered.width()))
        return fmt::format("covers none of the co-contractions in use, {} Nm: {}", span(cover.asked), limit);
    return fmt::format("covers co-contractions of {} Nm of the {} Nm in use: {}", span(cover.covered), span(cover.asked), limit);
}

std::string profile_block(const RedesignProfile& profile) {
    Rows rows;
    for (const Edit& c : profile.changes) rows.push_back({code(c.key), num(c.was), num(c.value), plain(c.why)});
    std::vector<std::string> findings;
    for (const core::Finding& finding : profile.findings) findings.push_back(core::to_line(finding));
    std::string out = subheading(profile.file.filename().string()) +
                      html_table("Changes of " + profile.file.filename().string(), {"key", "was", "is", "why"}, rows);
    out += paragraph(profile.can_be_cut() ? "fusee make can make these cams." : "fusee make will refuse these cams.");
    if (const std::string cover = coverage(profile.cover); !cover.empty()) out += paragraph("The profile " + cover + ".");
    return out + bullet_list(findings);
}

std::string redesign_summary(const Redesign& redesign) {
    return paragraph(fmt::format(
        "Largest error of the springs on the rig against the law of their cams: {} with the old cams, {} with new cams. Mean error of "
        "the dead-band as measured by a push-and-release test against the profile, over {} levels: {} with the old cams, {} with new "
        "cams; {}.",
        error_text(redesign.torque_error_old), error_text(redesign.torque_error_new), redesign.levels.size(),
        error_text(redesign.off_with_old_cams()), error_text(redesign.off_with_new_cams()), at_peak(redesign)));
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

}  // namespace

std::string redesign_section(const Redesign& redesign) {
    std::string out;
    if (!redesign.levels.empty()) out += redesign_summary(redesign) + redesign_chart(redesign) + widths_table(redesign);
    for (const RedesignProfile& profile : redesign.profiles) out += profile_block(profile);
    std::vector<std::string> remarks;
    for (const NotMended& n : redesign.not_mended) remarks.push_back("Cams do not correct " + cause_name(n.cause) + ": " + n.instead);
    remarks.insert(remarks.end(), redesign.remarks.begin(), redesign.remarks.end());
    return section("Cams for the rig as diagnosed", out + bullet_list(remarks));
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

}  // namespace fusee::report
