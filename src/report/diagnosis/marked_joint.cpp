#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "diagnosis/page.h"
#include "diagnosis/words.h"
#include "fusee/assembly/assembly.h"
#include "page/html.h"
#include "scene/scene.h"

namespace fusee::report {

namespace {

constexpr const char *kFaultyMark = "#d32f2f", *kPossibleMark = "#ef9b0f";

/// Where effects lie in the model of the joint: bodies by base name, or a cable; the first row whose `part` begins the effect's id counts.
struct Lies {
    std::string_view part;
    std::vector<std::string> bodies;
    std::string cable;
    std::string_view note;  ///< what the model leaves out
};
const std::array kLies{Lies{"se.radius", {"k_se"}, "", ""},
                       Lies{"se.", {"k_se_spring"}, "", ""},
                       Lies{"pe.radius", {"k_pe"}, "", ""},
                       Lies{"pe.", {"k_pe_spring"}, "", ""},
                       Lies{"gear.", {"capstan", "motor_shaft"}, "", "the gear itself is not modelled"},
                       Lies{"motor.", {"motor_shaft"}, "", "the motor itself is not modelled"},
                       Lies{"joint.stop", {"joint_stops"}, "", ""},
                       Lies{"joint.", {"joint_pulley"}, "", ""},
                       Lies{"cable.", {}, "series cable", ""}};

/// Names in the scene; empty for sensors and controller, which have no body.
std::vector<std::string> marked_names(const assembly::Assembly& joint, const effects::Cause& cause) {
    const auto lies = std::find_if(kLies.begin(), kLies.end(), [&](const Lies& l) { return cause.id.starts_with(l.part); });
    std::vector<std::string> names;
    if (lies == kLies.end()) return names;
    for (const char* const side : {"agonist", "antagonist"}) {
        if (cause.side != side && cause.side != "both" && cause.side != "none") continue;
        if (!lies->cable.empty()) names.push_back(lies->cable + ", " + side);
        for (const std::string& body : lies->bodies)
            if (joint.find(body + "_" + side) != nullptr) names.push_back(body + "_" + side);
    }
    for (const std::string& body : lies->bodies)
        if (joint.find(body) != nullptr) names.push_back(body);
    return names;
}

std::string place_line(const effects::Cause& cause, const std::vector<std::string>& names) {
    if (names.empty()) return cause_name(cause) + ": no body of the model is marked";
    const auto lies = std::find_if(kLies.begin(), kLies.end(), [&](const Lies& l) { return cause.id.starts_with(l.part); });
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return fmt::format("{}: {}{}{}", cause_name(cause), list, lies->note.empty() ? "" : "; ", lies->note);
}

}  // namespace

std::string marked_joint_section(const diagnosis::Diagnosis& diagnosis, const DesignReport& joint) {
    const auto [found, possible] = marked_causes(diagnosis);
    const bool named = !found.empty();
    const std::vector<effects::Cause>& causes = named ? found : possible;
    if (causes.empty()) return "";
    if (!joint.assembly) return joint_viewer_section(joint, {});
    Marks marks;
    std::set<std::string> lines;
    for (const effects::Cause& cause : causes) {
        const std::vector<std::string> names = marked_names(*joint.assembly, cause);
        for (const std::string& name : names) marks[name] = named ? kFaultyMark : kPossibleMark;
        lines.insert(place_line(cause, names));
    }
    const std::string words = named ? "Red: where the effects found lie." : "Orange: where the possible effects lie; none is certain.";
    return joint_viewer_section(joint, {}, &marks, paragraph(words) + bullet_list({lines.begin(), lines.end()}));
}

}  // namespace fusee::report
