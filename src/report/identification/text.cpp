#include <fmt/format.h>

#include <algorithm>

#include "fusee/report/identification.h"

namespace fusee::report {

std::string identification_text(const Identification& identification) {
    const gap_case::FrictionReport& friction = identification.friction;
    constexpr std::size_t kMostLines = 40;
    std::size_t width = 7;
    for (const gap_case::FrictionLine& line : friction.lines) width = std::max(width, line.group.size());
    width = std::min<std::size_t>(width, 40);
    std::string out = fmt::format(
        "{:{}}  rows      mu   (95 %)              constant Nm   (95 %)               mu at 0  robust mu  scatter Nm\n", "rows of", width);
    for (std::size_t i = 0; i < std::min(kMostLines, friction.lines.size()); ++i) {
        const gap_case::FrictionLine& line = friction.lines[i];
        out += fmt::format("{:{}}  {:4}  {:6.4f}   {:7.4f} to {:7.4f}   {:+11.5f}   {:+9.5f} to {:+8.5f}   {:6.4f}     {:6.4f}  {:10.5f}\n",
                           line.group, width, line.rows, line.mu, line.mu_95.low, line.mu_95.high, line.constant, line.constant_95.low,
                           line.constant_95.high, line.through_zero_mu, line.robust_mu, line.scatter);
    }
    if (friction.lines.size() > kMostLines)
        out += fmt::format("... and {} more in identification.json\n", friction.lines.size() - kMostLines);
    for (const gap_case::FrictionRemark& remark : friction.remarks) out += "- " + remark.text + "\n";
    if (!friction.law && !friction.one_way.empty())
        out += "\nNo lines for a profile: no motor has rows of both directions, drive and backdrive.\n";
    if (friction.law) out += "\nFor a profile:\n" + friction.profile_lines();
    return out;
}

}  // namespace fusee::report
