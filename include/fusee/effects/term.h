#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "fusee/effects/effect.h"

namespace fusee::effects {

/// A generic term for what no effect of the library describes: where it enters and on what it depends. As an effect it has an id
/// "term.PLACE.LAW", sides, parameters with scales and starts, and it is fitted in the same way (docs/theory/unknown.md).
struct Term {
    Effect effect;
    std::string port;        ///< "motor", "gear", "capstan encoder", "K_SE", "K_PE", "cable", "joint", "joint encoder"
    std::string depends_on;  ///< "angle", "speed", "other motor", "time", "load and time"
    std::string over,
        gives;  ///< of the curve: "capstan_rad", "joint_rad", "end_share", "rad_per_s", "time_s", "session_s", "torque_Nm"; "share",
                ///< "torque_Nm", "rad", ...
    double (*curve)(std::span<const double> values, double x) = nullptr;  ///< the law
    std::string sentence;  ///< subject and verb; {side} or {Side} ("the agonist's"), {size}, {share} in %, {turns}, {second} stand for side
                           ///< and values
};

/// All of them, in fixed order.
[[nodiscard]] const std::vector<Term>& term_library();
/// Their effects with the parameters of a rig.
[[nodiscard]] std::vector<Effect> terms_on(const gap_case::Reference& reference);
/// Null if the id is unknown.
[[nodiscard]] const Term* term_or_none(std::string_view id);
/// The library's effect or the term of this id. @throws core::InvalidInput listing the known ids
[[nodiscard]] const Effect& find_effect_or_term(const std::string& id);
/// The sentence of a term with its values.
[[nodiscard]] std::string sentence_of(const Term& term, const std::string& side, const std::vector<double>& values);

}  // namespace fusee::effects
