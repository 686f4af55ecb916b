#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "diagnosis/page.h"
#include "diagnosis/words.h"
#include "fusee/effects/effect.h"
#include "page/html.h"

namespace fusee::report {

namespace {

using Causes = std::vector<effects::Cause>;

/// A body of the schematic, by the first word of the effects that lie in it. Drawing units, of the agonist; the antagonist is its mirror
/// image. Without a side it stands in the middle.
struct Body {
    std::string_view part, name;
    double x, y, width, height;
    bool sided;
};
constexpr double kMechanismWidth = 520, kMechanismHeight = 400, kMiddle = 260;
constexpr std::array kBodies{Body{"sensor", "sensors", 212, 8, 96, 26, false},    Body{"joint", "joint pulley", 190, 56, 140, 40, false},
                             Body{"se", "K_SE", 60, 150, 110, 36, true},          Body{"gear", "gear and capstan", 40, 218, 150, 36, true},
                             Body{"motor", "motor", 75, 276, 80, 28, true},       Body{"pe", "K_PE", 60, 350, 110, 36, true},
                             Body{"loop", "controller", 210, 276, 100, 28, false}};
/// The cable from K_SE to the joint, and from the capstan to K_PE.
constexpr std::string_view kCable = "M115 150L205 96M176 254V368H170";

bool lies_in(const effects::Cause& cause, std::string_view part, std::string_view side) {
    return cause.id.starts_with(std::string(part) + ".") &&
           (side.empty() || cause.side == side || cause.side == "both" || cause.side == "none");
}

const char* state_of(const Causes& found, const Causes& possible, std::string_view part, std::string_view side) {
    const auto any = [&](const Causes& causes) {
        return std::any_of(causes.begin(), causes.end(), [&](const effects::Cause& cause) { return lies_in(cause, part, side); });
    };
    return any(found) ? "faulty" : any(possible) ? "possible" : "sound";
}

/// @param mirrored on the antagonist's side
std::string body_svg(const Body& body, const char* state, bool mirrored) {
    const double x = mirrored ? kMechanismWidth - body.x - body.width : body.x;
    return fmt::format(
        "<g class=\"{}\"><rect class=\"thing\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"6\"/><text x=\"{}\" y=\"{}\" "
        "text-anchor=\"middle\">{}</text></g>",
        state, x, body.y, body.width, body.height, x + body.width / 2, body.y + body.height / 2 + 4, body.name);
}

std::string side_svg(const Causes& found, const Causes& possible, bool mirrored) {
    const char* const side = mirrored ? "antagonist" : "agonist";
    std::string out = fmt::format(
        "<g class=\"{}\"{}><path class=\"line\" d=\"{}\"/></g><path class=\"rule\" d=\"{}\"/>"
        "<text class=\"note\" x=\"{}\" y=\"140\" text-anchor=\"{}\">{}</text>",
        state_of(found, possible, "cable", side), mirrored ? " transform=\"matrix(-1 0 0 1 520 0)\"" : "", kCable,
        mirrored ? "M405 186V218M405 254V276" : "M115 186V218M115 254V276", mirrored ? kMechanismWidth - 10 : 10.0,
        mirrored ? "end" : "start", side);
    for (const Body& body : kBodies)
        if (body.sided) out += body_svg(body, state_of(found, possible, body.part, side), mirrored);
    return out;
}

/// Of the most probable set, which the verdict does not confirm, and of its alternatives.
Causes possible_causes(const diagnosis::Diagnosis& diagnosis) {
    Causes all = found_causes(diagnosis);
    for (const diagnosis::Alternative& alternative : diagnosis.alternatives)
        all.insert(all.end(), alternative.effects.begin(), alternative.effects.end());
    return all;
}

std::string schematic(const Causes& found, const Causes& possible) {
    std::string out = fmt::format(
        "<figure class=\"plot schema\"><figcaption>The joint</figcaption><svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"The joint; "
        "faulty: {}\">",
        kMechanismWidth, kMechanismHeight, escape(causes_name(found.empty() ? possible : found, ", ")));
    out += side_svg(found, possible, false) + side_svg(found, possible, true);
    for (const Body& body : kBodies)
        if (!body.sided) out += body_svg(body, state_of(found, possible, body.part, ""), false);
    return out + "</svg></figure>";
}

std::string cause_lines(const Causes& causes) {
    std::vector<std::string> lines;
    std::set<std::string> named;
    for (const effects::Cause& cause : causes)
        if (named.insert(cause_name(cause)).second) lines.push_back(cause_name(cause) + ": " + meaning(cause.id));
    return bullet_list(lines);
}

}  // namespace

Marked marked_causes(const diagnosis::Diagnosis& diagnosis) {
    const bool named = diagnosis.verdict == diagnosis::VerdictKind::kIdentified;
    const bool agrees = diagnosis.verdict == diagnosis::VerdictKind::kNone || diagnosis.verdict == diagnosis::VerdictKind::kInconclusive;
    Marked all{named ? found_causes(diagnosis) : Causes{}, named || agrees ? Causes{} : possible_causes(diagnosis)};
    const auto outside = [](const effects::Cause& cause) { return effects::effect_or_none(cause.id) == nullptr; };
    std::erase_if(all.found, outside);
    std::erase_if(all.possible, outside);
    return all;
}

std::string place_section(const diagnosis::Diagnosis& diagnosis) {
    const auto [found, possible] = marked_causes(diagnosis);
    if (found.empty() && possible.empty()) return "";
    const bool named = !found.empty();
    const std::string words = named ? "Marked: where the effects found lie." : "Marked: where the possible effects lie; none is certain.";
    return section("The faulty place", grid(schematic(found, possible) + card(paragraph(words) + cause_lines(named ? found : possible))));
}

}  // namespace fusee::report
