#include "common/mill_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "fusee/core/units.h"
#include "fusee/toolpath/settings.h"

namespace fusee::formats {

namespace {

using core::mm_from_m;

constexpr double kPlateCell_mm = 0.15, kWrapCell_mm = 0.2;
constexpr int kDirections = 180;      // of the normal, in which the stock is compared with the drawn groove
constexpr double kInside_mm = 0.5;    // of the floor: also a gouge deeper than this shows there; pins stand farther inside
constexpr double kAllowed_mm = 0.02;  // beyond the width of a cell and the height of a terrace

/// Half the drawn groove's width at an offset from the pitch curve; 0 inside the floor [mm].
double half_width(const std::vector<solid::SectionPoint>& section, double offset) {
    const auto upper = section.begin() + static_cast<long>(section.size() / 2);
    if (offset <= upper->offset_mm) return 0.0;
    const auto above =
        std::lower_bound(upper, section.end(), offset, [](const solid::SectionPoint& p, double o) { return p.offset_mm < o; });
    if (above == section.end()) return section.back().z_mm;
    const auto below = std::prev(above);
    return below->z_mm + (above->z_mm - below->z_mm) * (offset - below->offset_mm) / std::max(1e-12, above->offset_mm - below->offset_mm);
}

/// Worst differences between what a program leaves and what is drawn [mm].
struct Difference {
    double gouge = 0.0, excess = 0.0;
};

/// @param cut half the groove's width that the stock has at a place of the body frame; below 0: no material @param step of terraces
template <class Cut>
Difference compare(const solid::Part& part, double cell, double step, const Cut& cut) {
    const auto& section = part.section;
    const double floor = section[section.size() / 2].offset_mm, lip = section.front().offset_mm;
    Difference worst;
    for (int i = 0; i < kDirections; ++i) {
        const double psi = part.cam.groove_psi.low + core::kTurn * i / kDirections;
        const cam::PathPoint p = part.cam.path(psi);
        for (double offset = floor - kInside_mm; offset < lip; offset += 0.5 * cell) {
            const double x = mm_from_m(p.x()) + offset * std::cos(psi), y = mm_from_m(p.y()) + offset * std::sin(psi);
            const double found = cut(x, y);
            if (found < 0.0) {  // bore and pins within the floor are meant; beyond it the outline is too small
                if (offset > floor && offset < lip - cell) worst.gouge = std::max(worst.gouge, lip - offset);
                continue;
            }
            worst.gouge = std::max(worst.gouge, found - half_width(section, offset + cell) - step);
            worst.excess = std::max(worst.excess, half_width(section, offset - cell) - found);
        }
    }
    return worst;
}

core::Finding difference(const char* rule, const char* what, double measured, const std::string& file) {
    core::Finding f;
    f.rule = rule;
    f.what = what;
    f.measured = measured;
    f.bound = core::Bound::kAtMost;
    f.allowed = kAllowed_mm;
    f.unit = "mm";
    f.where = file;
    f.suggestion = "report this program as an error of fusee";
    f.source = "docs/guides/milling.md: simulation of stock and holder";
    return core::judged(f, core::Severity::kError);
}

void judge_groove(Milled& milled, const Difference& worst) {
    milled.findings.push_back(difference("millsim.gouge", "the program cuts deeper than the drawn groove", worst.gouge, milled.file));
    milled.findings.push_back(difference("millsim.excess", "the program leaves material in the drawn groove", worst.excess, milled.file));
}

/// The groove of half plates: the depth of the stock below the groove's plane, on the way out from the bore.
Difference plates_difference(const solid::Part& part, const Milled& milled, double terrace) {
    Difference worst;
    for (const toolpath::mill::Comment& comment : milled.program.comments) {
        const auto& w = comment.words;
        if (w.size() != 5 || w[0] != "plate" || w[2] != "at") continue;
        const double shift = std::stod(w[3]), side = w[4] == "turned" ? -1.0 : 1.0;
        const Difference one = compare(part, kPlateCell_mm, terrace, [&](double x, double y) {
            const auto top = milled.result.stock.top(x + shift, side * y);
            return top ? std::min(-*top, part.section.back().z_mm) : -1.0;
        });
        worst = {std::max(worst.gouge, one.gouge), std::max(worst.excess, one.excess)};
    }
    return worst;
}

/// The gap of a wrapped groove about its plane.
double gap(const toolpath::mill::Stock& stock, double x, double y, double widest) {
    if (stock.at(x, y).empty()) return -1.0;
    double half = widest;
    for (const auto& one : stock.at(x, y))
        half = std::min(half, one[0] <= 0.0 && one[1] >= 0.0 ? 0.0 : std::min(std::abs(one[0]), std::abs(one[1])));
    return half;
}

bool cuts(const toolpath::mill::Program& program, const std::string& what) {
    return std::any_of(program.comments.begin(), program.comments.end(),
                       [&](const toolpath::mill::Comment& c) { return c.words.size() == 2 && c.words[0] == "cuts" && c.words[1] == what; });
}

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

std::vector<Milled> mill(const PartExport& out, const std::vector<toolpath::Program>& programs) {
    std::vector<Milled> all;
    all.reserve(programs.size());
    const solid::Part& part = out.part;
    for (const toolpath::Program& program : programs) {
        const std::string file = out.name() + program.suffix + ".ngc";
        toolpath::mill::Program moves = toolpath::mill::read_program(program.text, file);
        const bool wraps = cuts(moves, "wrap");
        std::optional<toolpath::mill::Stock> blank;
        if (wraps && !all.empty()) blank = toolpath::mill::released(all.back().result.stock, mm_from_m(out.settings.machining.tab_height));
        toolpath::mill::Result result =
            toolpath::mill::simulate(moves, wraps ? kWrapCell_mm : kPlateCell_mm, blank ? &*blank : nullptr, mm_from_m(part.z_high));
        Milled milled{file, std::move(moves), std::move(result), {}};
        milled.findings = toolpath::mill::contact_findings(milled.result, file);
        if (wraps && part.cam.closed())
            judge_groove(milled, compare(part, kWrapCell_mm, 0.0,
                                         [&](double x, double y) { return gap(milled.result.stock, x, y, part.section.back().z_mm); }));
        if (cuts(milled.program, "floor") && !part.cam.has_roller())
            judge_groove(milled, plates_difference(part, milled, mm_from_m(out.settings.machining.terrace)));
        all.push_back(std::move(milled));
    }
    return all;
}

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
