#include "figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <variant>

#include "fusee/actuator/dead_band.h"
#include "fusee/batch/batch.h"
#include "fusee/checks/limits.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/check.h"
#include "fusee/solid/mesh.h"

namespace fusee::batch {

namespace {

constexpr std::size_t kShownName = 80;  // characters

/// "dead_band_at_0_85_Nm_deg"
std::string dead_band_column(double torque) {
    std::string number = fmt::format("{:g}", torque);
    std::replace(number.begin(), number.end(), '.', '_');
    return "dead_band_at_" + number + "_Nm_deg";
}

/// A column of the index with the function that computes its figure.
template <class Source>
struct Definition {
    study::Column column;
    std::function<study::Figure(const Source&)> figure;
};
using DesignDefinition = Definition<pipeline::MadeDesign>;
using MadeDesign = pipeline::MadeDesign;

DesignDefinition dead_band_at(const std::string& column, const std::function<double(const actuator::Actuator&)>& torque) {
    return {{column, "exact dead-band, full width at the joint, at this equal co-contraction [deg]"}, [torque](const MadeDesign& made) {
                const actuator::Actuator& joint = made.resolved.actuator;
                return core::deg_from_rad(actuator::dead_band(joint, torque(joint)).exact_width);
            }};
}

/// @param torques as design_figures
std::vector<DesignDefinition> dead_band_definitions(const std::vector<double>& torques) {
    using actuator::Actuator;
    std::vector<DesignDefinition> all;
    for (const double torque : torques) all.push_back(dead_band_at(dead_band_column(torque), [torque](const Actuator&) { return torque; }));
    if (!all.empty()) return all;
    return {dead_band_at("dead_band_least_deg", [](const Actuator& joint) { return joint.least_torque; }),
            dead_band_at("dead_band_peak_deg", [](const Actuator& joint) { return joint.peak_torque; }),
            dead_band_at("dead_band_overdrive_deg", [](const Actuator& joint) { return joint.overdrive_torque; })};
}

double joint_stiffness(const actuator::Actuator& joint, double torque) { return actuator::dead_band(joint, torque).joint_stiffness; }

double worst_arm_error(const pipeline::Headline& headline) {
    double worst = std::nan("");
    for (const pipeline::MadeArm& arm : headline.arms) worst = std::fmax(worst, arm.worst_relative());
    return worst;
}

double volume_cm3(const MadeDesign& made) {
    double volume = 0.0;
    for (const pipeline::PartReport& part : made.report.parts) volume += 1e-3 * solid::volume_mm3(part.part->mesh);
    return volume;
}

double mass_g(const MadeDesign& made) { return 1e-3 * volume_cm3(made) * checks::material_of(made.resolved.profile.process).density; }

std::vector<DesignDefinition> joint_definitions() {
    const auto of_headline = [](const auto& figure) { return [figure](const MadeDesign& made) { return figure(made.report.headline); }; };
    using pipeline::Headline;
    return {
        {{"dead_band_built_low_deg", "at overdrive torque: 5 % of joints as a shop builds them are below [deg]"},
         of_headline([](const Headline& h) { return core::deg_from_rad(h.overdrive.built.low); })},
        {{"dead_band_built_high_deg", "at overdrive torque: 95 % of joints as a shop builds them are below [deg]"},
         of_headline([](const Headline& h) { return core::deg_from_rad(h.overdrive.built.high); })},
        {{"stiffness_least_Nm_per_rad", "joint stiffness at least torque, capstans at rest [Nm/rad]"},
         [](const MadeDesign& made) { return joint_stiffness(made.resolved.actuator, made.resolved.actuator.least_torque); }},
        {{"stiffness_overdrive_Nm_per_rad", "joint stiffness at overdrive torque, capstans at rest [Nm/rad]"},
         [](const MadeDesign& made) { return joint_stiffness(made.resolved.actuator, made.resolved.actuator.overdrive_torque); }},
        {{"joint_torque_Nm", "greatest joint torque at which every spring stays inside its law [Nm]"},
         of_headline([](const Headline& h) { return h.joint_torque; })},
        {{"condition_6", "condition (6), d(T tau_f)/dtau < 0: holds, fails, holds in part, within rounding, not known", true},
         of_headline([](const Headline& h) { return std::string(to_string(pipeline::condition_verdict(h.condition))); })},
        {{"shop_arm_error_percent", "largest arm error by the process's contour tolerance, either side [%]"},
         of_headline([](const Headline& h) { return 100.0 * worst_arm_error(h); })},
        {{"mass_g", "mass of K_SE and K_PE, full, in the process's material [g]"}, &mass_g},
    };
}

const pipeline::PartReport& part_of(const MadeDesign& made, cam::PartKind kind) {
    return *core::find_by(
        made.report.parts, [](const pipeline::PartReport& part) { return part.part->cam.kind; }, kind);
}

double greatest_tension(const pipeline::PartReport& part) {
    double tension = 0.0;
    for (const cam::Contact& contact : part.part->cam.working) tension = std::max(tension, contact.arm.tension);
    return tension;
}

/// @param kind none: the part of a single spring @param cam "series cam"
std::vector<DesignDefinition> part_definitions(std::optional<cam::PartKind> kind, const std::string& cam) {
    const std::string name = kind ? to_string(*kind) : "cam";
    const auto of_part = [kind](const auto& figure) {
        return [=](const MadeDesign& made) { return figure(kind ? part_of(made, *kind) : made.report.parts.front()); };
    };
    std::vector<DesignDefinition> all;
    for (std::size_t axis = 0; axis < 3; ++axis)
        all.push_back({{fmt::format("{}_{}_mm", name, "xyz"[axis]), "size of the " + cam + " [mm]"},
                       of_part([axis](const pipeline::PartReport& part) {
                           const solid::Box box = solid::bounding_box(part.part->mesh);
                           return box.high_mm[axis] - box.low_mm[axis];
                       })});
    all.push_back(
        {{name + "_tension_N", "greatest tension of the " + cam + "'s " + (kind ? "cable" : "cable, or load of its roller") + " [N]"},
         of_part(&greatest_tension)});
    all.push_back({{name + "_triangles", "triangles of the " + cam + "'s mesh"},
                   of_part([](const pipeline::PartReport& part) { return static_cast<double>(part.part->mesh.triangles.size()); })});
    return all;
}

/// Calls `take` with each file of a design.
template <class Take>
void each_file(const pipeline::DesignReport& report, const Take& take) {
    std::for_each(report.files.begin(), report.files.end(), take);
    for (const pipeline::PartReport* side : report.sides()) std::for_each(side->files.begin(), side->files.end(), take);
}

std::vector<DesignDefinition> file_definitions() {
    return {{{"arm_error_percent", "largest arm error of the files as read back [%]"},
             [](const MadeDesign& made) { return 100.0 * made.report.file_errors().arm; }},
            {{"dead_band_error_percent", "largest change of the dead-band by the files [%]"},
             [](const MadeDesign& made) { return 100.0 * made.report.file_errors().dead_band; }},
            {{"files", "files written"},
             [](const MadeDesign& made) {
                 double files = 0.0;
                 each_file(made.report, [&](const pipeline::FileRow&) { ++files; });
                 return files;
             }},
            {{"bytes", "size of the files"}, [](const MadeDesign& made) {
                 double bytes = 0.0;
                 each_file(made.report, [&](const pipeline::FileRow& row) { bytes += static_cast<double>(row.bytes); });
                 return bytes;
             }}};
}

/// @param figure of the finding of this rule; NaN where it was not judged
DesignDefinition of_rule(const char* column, const char* meaning, std::string_view rule, double (*figure)(const core::Finding&)) {
    return {{column, meaning}, [rule, figure](const MadeDesign& made) {
                for (const core::Finding& f : made.report.all_findings())
                    if (f.rule == rule && f.severity != core::Severity::kNotJudged) return figure(f);
                return std::nan("");
            }};
}

/// Of a profile of one spring.
std::vector<DesignDefinition> spring_definitions() {
    const auto of_law = [](const auto& figure) {
        return [figure](const MadeDesign& made) { return figure(*made.report.headline.spring); };
    };
    using pipeline::SpringFigures;
    std::vector<DesignDefinition> all{
        {{"torque_least_Nm", "least torque of the law, signed [Nm]"}, of_law([](const SpringFigures& s) { return s.torques.low; })},
        {{"torque_greatest_Nm", "greatest torque of the law, signed [Nm]"}, of_law([](const SpringFigures& s) { return s.torques.high; })},
        {{"torque_error_built_percent", "5 to 95 % of springs as a shop builds them are within +- this share of the largest torque [%]"},
         of_law([](const SpringFigures& s) { return 100.0 * s.built_error; })},
        of_rule("spring_stress_percent", "greatest stress of the base spring's wire over the allowed one [%]", "spring.stress",
                [](const core::Finding& f) { return 100.0 * f.measured / f.allowed; }),
        of_rule("spring_fatigue_safety", "safety of the base spring's wire for its cycles", "spring.fatigue",
                [](const core::Finding& f) { return f.measured; }),
        {{"volume_cm3", "volume of the part, full [cm^3]"}, &volume_cm3},
        {{"mass_g", "its mass in the process's material [g]"}, &mass_g},
    };
    all = core::joined(std::move(all), part_definitions(std::nullopt, "part"), file_definitions());
    std::erase_if(all, [](const DesignDefinition& d) { return d.column.name == "dead_band_error_percent"; });
    return all;
}

/// @param spring of a single spring
std::vector<DesignDefinition> design_definitions(const std::vector<double>& torques, bool spring) {
    if (spring) return spring_definitions();
    return core::joined(dead_band_definitions(torques), joint_definitions(), part_definitions(cam::PartKind::kSeries, "series cam"),
                        part_definitions(cam::PartKind::kParallel, "parallel cam"), file_definitions());
}

std::vector<Definition<core::Findings>> finding_definitions() {
    using core::Findings;
    const auto number_of = [](core::Severity severity) {
        return [severity](const Findings& findings) { return static_cast<double>(core::count(findings, severity)); };
    };
    const auto of_worst = [](const auto& text) {
        return [text](const Findings& findings) {
            const core::Finding* worst = pipeline::binding(findings);
            return worst != nullptr ? study::Figure(text(*worst)) : study::Figure(std::nan(""));
        };
    };
    return {{{"errors", "rules that are broken"}, number_of(core::Severity::kError)},
            {{"warnings", "rules that ask for a review"}, number_of(core::Severity::kWarning)},
            {{"not_judged", "rules that the profile gives too little data for"}, number_of(core::Severity::kNotJudged)},
            {{"worst_rule", "the binding rule of the highest severity", true}, of_worst([](const core::Finding& f) { return f.rule; })},
            {{"worst_finding", "its finding in one line", true}, of_worst([](const core::Finding& f) { return core::to_line(f); })}};
}

template <class Source>
void add_columns(std::vector<study::Column>& to, const std::vector<Definition<Source>>& definitions) {
    for (const auto& definition : definitions)
        if (std::none_of(to.begin(), to.end(), [&](const study::Column& known) { return known.name == definition.column.name; }))
            to.push_back(definition.column);
}

template <class Source>
void add_figures(Figures& to, const std::vector<Definition<Source>>& definitions, const Source& source) {
    for (const auto& [column, figure] : definitions) to.emplace_back(column.name, figure(source));
}

/// The contour of a closed cam or the projection of a helix, in units of its largest radius: "x,y x,y ...".
std::string outline(const cam::Cam& cam) {
    constexpr int kPoints = 48;
    std::vector<cam::PathPoint> points;
    double largest = 0.0;
    for (int i = 0; i < kPoints; ++i) {
        points.push_back(cam.path(cam.groove_psi.low + cam.groove_psi.width() * i / kPoints));
        largest = std::max(largest, std::hypot(points.back().x(), points.back().y()));
    }
    return core::listed(
        points, [&](const cam::PathPoint& p) { return fmt::format("{:.3f},{:.3f}", p.x() / largest, p.y() / largest); }, " ");
}

}  // namespace

std::vector<study::Column> index_columns(const study::Plan& plan) {
    std::vector<study::Column> columns{{"outcome", "made, or refused because a limit cannot be kept", true}};
    for (const study::Variation& v : plan.study().vary) {
        const bool is_text = !v.values.empty() && v.values.front().starts_with('"');
        columns.push_back({study::column_name(v.key), "key " + v.key + " of the profile", is_text});
    }
    if (plan.has_joints()) add_columns(columns, design_definitions(plan.study().torques, false));
    if (plan.has_springs()) add_columns(columns, design_definitions(plan.study().torques, true));
    add_columns(columns, finding_definitions());
    return columns;
}

Figures varied_figures(const study::Plan& plan, const study::Planned& planned) {
    Figures figures;
    for (std::size_t i = 0; i < planned.values.size(); ++i) {
        const std::string& text = planned.values[i];
        double number = std::nan("");
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        const bool is_number = error == std::errc() && end == text.data() + text.size();
        study::Figure figure = number;
        if (!is_number) figure = text.size() >= 2 && text.front() == '"' ? text.substr(1, text.size() - 2) : text;
        figures.emplace_back(study::column_name(plan.study().vary[i].key), std::move(figure));
    }
    return figures;
}

study::RowFault row_fault(const study::Plan& plan) {
    enum class Kind { kNumber, kText, kAny };
    std::map<std::string, Kind> known{{"k_se_outline", Kind::kText}, {"k_pe_outline", Kind::kText}};
    for (const study::Column& column : index_columns(plan)) known[column.name] = column.is_text ? Kind::kText : Kind::kNumber;
    for (const study::Variation& v : plan.study().vary) known[study::column_name(v.key)] = Kind::kAny;
    return [known](const study::Row& row) -> std::string {
        for (const auto& [name, figure] : row.figures) {
            const auto found = known.find(name);
            if (found == known.end())
                return fmt::format("has a figure \"{}\", which this study has not: a row of another study or version",
                                   core::printable(name, kShownName));
            const auto* number = std::get_if<double>(&figure);
            if (number != nullptr && std::isnan(*number)) continue;  // not known
            if (found->second == (number != nullptr ? Kind::kText : Kind::kNumber))
                return fmt::format("its figure {} is a {}", name, number != nullptr ? "number, not a text" : "text, not a number");
        }
        const study::Figure* outcome = row.find("outcome");
        const bool has_ended = outcome != nullptr && (*outcome == study::Figure(to_string(Outcome::kMade)) ||
                                                      *outcome == study::Figure(to_string(Outcome::kRefused)));
        return has_ended ? "" : "its outcome is neither made nor refused";
    };
}

Figures finding_figures(const core::Findings& findings) {
    Figures figures;
    add_figures(figures, finding_definitions(), findings);
    return figures;
}

Figures design_figures(const pipeline::MadeDesign& made, const std::vector<double>& torques) {
    Figures figures;
    add_figures(figures, design_definitions(torques, made.resolved.profile.is_spring()), made);
    for (const pipeline::PartReport& part : made.report.parts)
        figures.emplace_back(std::string(to_string(part.part->cam.kind)) + "_outline", outline(part.part->cam));
    add_figures(figures, finding_definitions(), made.report.all_findings());
    return figures;
}

}  // namespace fusee::batch
