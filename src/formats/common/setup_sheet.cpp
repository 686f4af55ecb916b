#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <map>

#include "common/mill_check.h"
#include "fusee/core/units.h"
#include "fusee/toolpath/settings.h"

namespace fusee::formats {

namespace {

/// Comments for the simulation, not for a person.
bool for_machines(const std::vector<std::string>& w) {
    constexpr std::array kWords{"cuts", "cutter", "rotary", "clamp", "board", "tool", "plate", "hole", "held", "index"};
    for (const char* word : kWords)
        if (!w.empty() && w[0] == word) return true;
    return false;
}

std::string tools_of(const Milled& milled) {
    std::map<int, double> minutes;
    for (const toolpath::mill::Move& move : milled.program.moves) minutes[move.tool] += move.minutes;
    std::string text = "| tool | holder | time at the programmed feeds |\n|---|---|---|\n";
    for (const toolpath::mill::Comment& comment : milled.program.comments) {
        const auto& w = comment.words;
        if (w.empty() || w[0].size() != 3 || w[0][0] != 'T' || w[0][2] != ':') continue;
        const int number = w[0][1] - '0';
        double holder = 0.0;
        for (const toolpath::mill::Comment& other : milled.program.comments)
            if (other.words.size() > 2 && other.words[0] == "tool" && other.words[1] == std::to_string(number))
                holder = std::stod(other.words.back());
        text += fmt::format("| {} | {:.1f} mm | {:.1f} min |\n", fmt::join(w, " "), holder, minutes[number]);
    }
    return text;
}

std::string checks_of(const Milled& milled) {
    std::string text =
        "- no rapid through the stock or below the clamps, no contact of shank, holder, clamps or board; tool changes, holes, index, tabs";
    if (!milled.result.contacts.empty()) text = "- CONTACT: see the findings of this program";
    for (const core::Finding& f : milled.findings)
        if (f.rule == "millsim.gouge" || f.rule == "millsim.excess")
            text += fmt::format("\n- {}: {:.3f} mm, at most {:.3f} mm", f.what, f.measured, f.allowed);
    return text + "\n";
}

}  // namespace

std::string setup_sheet(const Milled& milled, const PartExport& out) {
    std::string text = fmt::format("# Setup sheet: {}\n\n{}\n\n## Stock, zero, clamping\n", milled.file, out.provenance.line());
    for (const toolpath::mill::Comment& comment : milled.program.comments) {
        const auto& w = comment.words;
        if (for_machines(w) || w.empty() || w[0] == "fusee" || (w[0].size() == 3 && w[0][0] == 'T' && w[0][2] == ':')) continue;
        text += fmt::format("- {}\n", fmt::join(w, " "));
    }
    text += fmt::format("\n## Tools and operations, in this order\n{}\nTotal {:.1f} min with rapids at 3 m/min, without tool changes.\n",
                        tools_of(milled), milled.result.minutes);
    text += fmt::format("\n## Checks by simulation of stock and holder\n{}", checks_of(milled));
    text += "- not checked: cutting forces, deflection, chatter, the machine's travel\n";
    if (!checks::is_milled(out.settings.process))
        text += fmt::format(
            "\nThe part was judged for {}; speeds and feeds here are those of milling {}. `fusee check --process mill` or `mill4` lists "
            "what a mill objects to.\n",
            checks::to_string(out.settings.process.kind), toolpath::to_string(out.settings.machining.stuff));
    return text;
}

}  // namespace fusee::formats
