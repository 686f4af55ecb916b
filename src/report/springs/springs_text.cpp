#include <fmt/format.h>

#include "fusee/core/units.h"
#include "fusee/report/springs.h"

namespace fusee::report {

namespace {

using core::mm_from_m;

constexpr std::size_t kMostRules = 5;

std::string line(const pipeline::FoundSpring& found, const spring::BaseSpring& wanted) {
    const spring::BaseSpring& s = found.spring;
    const bool torsion = s.kind == spring::BaseKind::kTorsion;
    return fmt::format("  {:<6} {:<18} {:>9.4g} {} ({:+.1f} %), preload {:.4g} {}, {} {:.4g} mm, rod {:.4g} mm\n",
                       found.bought ? "bought" : "wound", found.name, s.rate, torsion ? "Nm/rad" : "N/m",
                       100.0 * (s.rate / wanted.rate - 1.0), torsion ? s.preload : mm_from_m(s.preload), torsion ? "rad" : "mm",
                       torsion ? "axial space" : "free length", mm_from_m(s.free_length), mm_from_m(s.rod_diameter));
}

}  // namespace

std::string springs_text(const pipeline::SpringSearch& search) {
    const bool torsion = search.wanted.kind == spring::BaseKind::kTorsion;
    std::string text = fmt::format("{}: {} spring of {:.4g} {}, {:.4g} to {:.4g} {}; {} springs tried; wound: wire x coil x turns [mm]\n",
                                   search.table, torsion ? "torsion" : "compression", search.wanted.rate, torsion ? "Nm/rad" : "N/m",
                                   search.loads.low, search.loads.high, torsion ? "Nm" : "N", search.tried);
    for (const auto* springs : {&search.wound, &search.bought})
        for (const pipeline::FoundSpring& found : *springs) text += line(found, search.wanted);
    if (!search.wound.empty() || !search.bought.empty()) return text;
    text += "  none passes; broken or not judged:\n";
    for (std::size_t i = 0; i < std::min(kMostRules, search.broken.size()); ++i)
        text += fmt::format("    {} by {} springs\n", search.broken[i].first, search.broken[i].second);
    return text;
}

}  // namespace fusee::report
