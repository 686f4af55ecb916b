#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/report/diagnosis.h"

/// A diagnosis in words; all results are plain texts, not yet escaped.
namespace fusee::report {

/// A probability; "< 0.001" below a thousandth; nothing is certain: "> 0.999".
[[nodiscard]] std::string chance(double probability);

/// Lengths in millimetres, pure numbers ("1") without a unit, everything else unchanged.
[[nodiscard]] diagnosis::Parameter for_reading(diagnosis::Parameter parameter);
/// The same, a share in per cent, as on the page.
[[nodiscard]] diagnosis::Parameter in_line(const diagnosis::Parameter& parameter);
/// "0.12 Nm", without a unit for pure numbers; of a parameter of for_reading.
[[nodiscard]] std::string amount(const diagnosis::Parameter& parameter);

/// "dead_band" is "dead-band", "force_loop" is "force loop".
[[nodiscard]] std::string experiment_name(const std::string& id);
/// A column of a table: "q_high_rad" is "q high [rad]", "v_m_s" is "v [m/s]".
[[nodiscard]] std::string column_name(std::string_view column);
/// "gear.coulomb (agonist)"
[[nodiscard]] std::string cause_name(const effects::Cause& cause);
/// Joined with `between`; "no effect" if there is none.
[[nodiscard]] std::string causes_name(const std::vector<effects::Cause>& causes, const std::string& between = " and ");
/// Its law in symbols and effects of similar signature; "" for an id that is not in the library.
[[nodiscard]] std::string law(std::string_view effect_id);

/// "dead-band, co-contraction 0.12 to 0.5 Nm, agonist"
[[nodiscard]] std::string place(const diagnosis::GapContribution& where);
[[nodiscard]] std::vector<effects::Cause> found_causes(const diagnosis::Diagnosis& diagnosis);
/// The verdict in a sentence.
/// The sentences of the generic terms, one after the other.
[[nodiscard]] std::string form_of(const diagnosis::Diagnosis& diagnosis);
[[nodiscard]] std::string verdict_sentence(const diagnosis::Diagnosis& diagnosis);
/// Which causes hold on the other case, a line each, and the gaps there; none without Diagnosis::against.
[[nodiscard]] std::vector<std::string> against_lines(const diagnosis::Diagnosis& diagnosis);
/// Probability of the verdict: of its least certain effect, or of none. NaN where the ranking does not state it.
[[nodiscard]] double verdict_probability(const diagnosis::Diagnosis& diagnosis);

}  // namespace fusee::report
