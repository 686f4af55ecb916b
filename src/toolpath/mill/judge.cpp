#include <fmt/format.h>

#include "fusee/toolpath/mill.h"

namespace fusee::toolpath::mill {

namespace {

/// What a measured value is: most are lengths.
const char* unit_of(const std::string& rule) {
    if (rule == "millsim.free") return "mm2";
    return rule == "millsim.tool_change" || rule == "millsim.approach" || rule == "millsim.arc_mode" ? "" : "mm";
}

}  // namespace

core::Findings contact_findings(const Result& result, const std::string& name) {
    core::Findings findings;
    for (const Contact& contact : result.contacts) {
        core::Finding f =
            core::error_finding(contact.rule, fmt::format("{}, first in line {}, {} moves", contact.what, contact.line, contact.moves),
                                contact.measured, core::Bound::kAtMost, 0.0, unit_of(contact.rule));
        f.where = name;
        f.suggestion = contact.rule == "millsim.holder" || contact.rule == "millsim.clamp"
                           ? fmt::format("machining.stick_out_mm longer by {:.1f}, or a smaller holder or chuck", contact.measured + 0.1)
                       : contact.rule == "millsim.free"  ? "machining.tabs, or machining.tab_width_mm smaller"
                       : contact.rule == "millsim.shank" ? fmt::format("machining.flute_length_mm longer by {:.1f}", contact.measured + 0.1)
                                                         : "report this program as an error of fusee";
        f.source = "docs/guides/milling.md: simulation of stock and holder";
        findings.push_back(std::move(f));
    }
    return findings;
}

}  // namespace fusee::toolpath::mill
