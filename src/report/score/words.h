#pragma once
#include <string>

#include "fusee/blind/score.h"

/// Figures of a score in words; all results are plain texts, not yet escaped.
namespace fusee::report {

/// 0.9512 is "95.1 %"; a dash for NaN.
[[nodiscard]] std::string per_cent(double share);
/// "91.9 to 97.0 %"
[[nodiscard]] std::string per_cent(const core::Range& range);
/// Its Wilson interval; "" without cases.
[[nodiscard]] std::string interval_text(const blind::Share& share);
/// "12 of 30"
[[nodiscard]] std::string hits_text(const blind::Share& share);
/// "at least 95 %", "90 to 99 %", "at most 5 %"; "" without a target.
[[nodiscard]] std::string wanted_text(const core::Range& wanted);
/// "gear.coulomb (agonist) 0.05", "none"
[[nodiscard]] std::string truth_text(const blind::Label& label);
/// "identified: gear.coulomb (both) 0.05 (95 %: 0.04 to 0.06)"
[[nodiscard]] std::string answer_text(const blind::Answer& answer);
/// "se.radius (both) 0.4; none 0.1"
[[nodiscard]] std::string alternatives_text(const blind::Answer& answer);

}  // namespace fusee::report
