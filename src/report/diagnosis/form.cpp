#include <fmt/format.h>

#include "diagnosis/page.h"
#include "diagnosis/words.h"
#include "fusee/effects/term.h"
#include "page/html.h"
#include "page/svg_plot.h"

namespace fusee::report {

namespace {

std::string form_axis(const std::string& name) {
    if (name == "capstan_rad") return "capstan angle [rad]";
    if (name == "joint_rad") return "joint angle [rad]";
    if (name == "end_share") return "deflection over that of the cam's end";
    if (name == "time_s") return "time [s]";
    if (name == "session_s") return "time of the session [s]";
    if (name == "torque_Nm") return "torque [Nm]";
    if (name == "rad_per_s") return "speed [rad/s]";
    if (name == "rad") return "angle [rad]";
    return name == "s" ? "delay [s]" : "factor or share";
}

Rows parameters_of(const diagnosis::UnknownTerm& term) {
    const diagnosis::Parameter p = for_reading(term.found.parameter);
    Rows rows{{plain("size"), num(p.value, 3), num(span(p.ci95)), plain(p.unit)}};
    const std::vector<effects::EffectParameter>& law = effects::find_effect_or_term(term.found.cause.id).parameters;
    for (std::size_t i = 0; i < term.found.extra.size(); ++i)
        rows.push_back({plain(term.found.extra[i].first), num(term.found.extra[i].second, 3), plain(""), plain(law[i + 1].unit)});
    return rows;
}

std::string term_part(const diagnosis::UnknownTerm& term) {
    Plot plot(cause_name(term.found.cause), form_axis(term.x_name), form_axis(term.y_name));
    if (!term.x.empty()) plot.curve("law as fitted", term.x, term.y, "se");
    return paragraph(term.sentence) +
           paragraph(fmt::format("It enters at the {}, and depends on: {}. Law: {} Probability among the forms that were tried: {}.",
                                 term.port, term.depends_on, term.law, chance(term.found.probability))) +
           (term.x.empty() ? "" : plot.svg()) +
           dense_table("Values of " + cause_name(term.found.cause), {"value", "as fitted", "95 %", "unit"}, parameters_of(term));
}

}  // namespace

std::string form_section(const diagnosis::Diagnosis& diagnosis) {
    if (diagnosis.unknown_terms.empty()) return "";
    std::string out = paragraph(
        "No effect of the library explains the gap. Generic laws were fitted at every place of the joint; what follows explains "
        "most of it. It is a form, not a cause: check that place.");
    for (const diagnosis::UnknownTerm& term : diagnosis.unknown_terms) out += term_part(term);
    return section("Form of the unknown effect", out);
}

}  // namespace fusee::report
