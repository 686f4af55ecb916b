#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fusee/gap/diagnosis.h"

/// How a diagnosis is put into words; all results are plain texts, not yet escaped.
namespace fusee::report {

/// `digits` significant digits; a dash for NaN and for infinities.
[[nodiscard]] std::string known(double value, int digits = 3);
/// "0.12 to 0.5"; a dash if an end is not known.
[[nodiscard]] std::string span(const core::Range& range);
/// "9.1 \u2192 1.04"
[[nodiscard]] std::string change(double before, double after);
/// A probability; what rounds to none is "< 0.001".
[[nodiscard]] std::string chance(double probability);
/// 0.62 is "62 %".
[[nodiscard]] std::string percent(double share);

/// Lengths in millimetres and no unit for pure numbers ("1"), all else as it is: three hundredths of a millimetre are not
/// read well as 3e-05 m.
[[nodiscard]] gap::Parameter for_reading(gap::Parameter parameter);
/// "0.12 Nm", without a unit for pure numbers; of a parameter made ready by for_reading.
[[nodiscard]] std::string amount(const gap::Parameter& parameter);

/// "dead_band" is "dead-band", "force_loop" is "force loop".
[[nodiscard]] std::string experiment_name(const std::string& id);
/// A column of a table: "q_high_rad" is "q high [rad]", "v_m_s" is "v [m/s]".
[[nodiscard]] std::string column_name(std::string_view column);
/// "gear.coulomb (agonist)"
[[nodiscard]] std::string cause_name(const gap::Cause& cause);
/// Joined with `between`; "no effect" if there is none.
[[nodiscard]] std::string causes_name(const std::vector<gap::Cause>& causes, const std::string& between = " and ");
/// What an effect means for the rig, in a sentence; "" for an id without one.
[[nodiscard]] std::string meaning(std::string_view effect_id);
/// Its law in symbols and what has a like signature in some experiments; "" for an id that is not in the library.
[[nodiscard]] std::string law(std::string_view effect_id);

/// "dead-band, co-contraction 0.12 to 0.5 Nm, agonist"
[[nodiscard]] std::string place(const gap::Whereabouts& where);
[[nodiscard]] std::vector<gap::Cause> found_causes(const gap::Diagnosis& diagnosis);
/// The verdict in a sentence.
[[nodiscard]] std::string verdict_sentence(const gap::Diagnosis& diagnosis);
/// Of the verdict: of its least certain effect, or of there being none. NaN where the ranking cannot say it.
[[nodiscard]] double verdict_probability(const gap::Diagnosis& diagnosis);

}  // namespace fusee::report
