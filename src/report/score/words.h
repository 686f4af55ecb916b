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
/// "at least 95 %", "90 to 99 %", "at most 5 %"; "" without a target.
[[nodiscard]] std::string wanted_text(const core::Range& wanted);

}  // namespace fusee::report
