#pragma once
#include <string>

#include "fusee/blind/score.h"

/// One answer against its label.
namespace fusee::blind {

[[nodiscard]] bool knows_effects(const Label& label);  ///< one or two of the library
/// The answer states effects: it is identified or partly explained.
[[nodiscard]] bool has_name(const Answer& answer);
/// It states these effects and no other; with `sides`, on these sides.
[[nodiscard]] bool names(const Answer& answer, const Label& label, bool sides);
/// The same, or an ambiguous answer that has these effects first or among its alternatives.
[[nodiscard]] bool leaves_open(const Answer& answer, const Label& label);
/// The same with sides; none or inconclusive on a faultless rig; inconclusive of two experiments. @pre a doubtful label
[[nodiscard]] bool is_right_in_doubt(const Answer& answer, const Label& label);
/// It is identified, with an effect that is not built in on this side.
[[nodiscard]] bool identifies_a_wrong_effect(const Answer& answer, const Label& label);
[[nodiscard]] bool has_verdict(const Answer& answer, diagnosis::VerdictKind verdict);
[[nodiscard]] bool halves_the_gap(const Answer& answer);
/// The answer's first generic term enters where the outside effect does.
[[nodiscard]] bool has_port(const Answer& answer, const Label& label);
/// Stated effects that do not enter where the outside effect does.
[[nodiscard]] std::size_t misplaced(const Answer& answer, const Label& label);
/// The first generic term, or every stated effect, enters where the outside effect does.
[[nodiscard]] bool tells_place(const Answer& answer, const Label& label);
/// And depends on the same quantity.
[[nodiscard]] bool has_dependence(const Answer& answer, const Label& label);
/// The label's effect that this one is, same side; nullptr: none.
[[nodiscard]] const LabelEffect* found_in(const Label& label, const diagnosis::FoundEffect& effect);
/// Description of the error; "" if the answer is right.
[[nodiscard]] std::string miss_of(const Label& label, const Answer& answer);

}  // namespace fusee::blind
