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

/// Where effects lie in the model of the joint; the first row whose `part` begins the effect's id counts.
struct Lies {
    std::string_view part;
    std::array<std::string_view, 2> bodies;  ///< base names; "" for none
    std::string_view cable, note;            ///< note: what the model leaves out
};
constexpr std::array kLies{Lies{"se.radius", {"k_se"}, "", ""},
                           Lies{"se.", {"k_se_spring"}, "", ""},
                           Lies{"pe.radius", {"k_pe"}, "", ""},
                           Lies{"pe.", {"k_pe_spring"}, "", ""},
                           Lies{"gear.", {"capstan", "motor_shaft"}, "", "; the gear itself is not modelled"},
                           Lies{"motor.", {"motor_shaft"}, "", "; the motor itself is not modelled"},
                           Lies{"joint.stop", {"joint_stops"}, "", ""},
                           Lies{"joint.", {"joint_pulley"}, "", ""},
                           Lies{"cable.", {}, "series cable", ""},
                           Lies{"", {}, "", ""}};  // sensors and controller have no body

const Lies& lies_of(const effects::Cause& cause) {
    return *std::find_if(kLies.begin(), kLies.end(), [&](const Lies& lies) { return cause.id.starts_with(lies.part); });
}

/// Names in the scene. A body without a side has its base name.
std::vector<std::string> marked_names(const assembly::Assembly& joint, const effects::Cause& cause) {
    const Lies& lies = lies_of(cause);
    std::vector<std::string> names;
    for (const char* const side : {"agonist", "antagonist", ""}) {
        if (cause.side != side && cause.side != "both" && cause.side != "none") continue;
        const std::string end = side;
        if (!end.empty() && !lies.cable.empty()) names.push_back(fmt::format("{}, {}", lies.cable, end));
        for (const std::string_view body : lies.bodies)
            if (const std::string name = fmt::format("{}{}{}", body, end.empty() ? "" : "_", end); joint.find(name) != nullptr)
                names.push_back(name);
    }
    return names;
}

std::string place_line(const effects::Cause& cause, const std::vector<std::string>& names) {
    if (names.empty()) return cause_name(cause) + ": no body of the model is marked";
    return fmt::format("{}: {}{}", cause_name(cause), fmt::join(names, ", "), lies_of(cause).note);
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
