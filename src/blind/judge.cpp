#include "judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "fusee/core/error.h"

namespace fusee::blind {

namespace {

constexpr double kEnough = 0.5;  ///< of the held-out gap may be left

effects::Cause cause_of(const LabelEffect& effect) { return {effect.id, effect.side}; }
const effects::Cause& cause_of(const diagnosis::FoundEffect& effect) { return effect.cause; }
const effects::Cause& cause_of(const effects::Cause& cause) { return cause; }

template <typename Effects>
bool same(const Label& label, const Effects& effects, bool sides) {
    return std::is_permutation(
        label.effects.begin(), label.effects.end(), effects.begin(), effects.end(),
        [&](const auto& a, const auto& b) { return cause_of(a).id == cause_of(b).id && (!sides || cause_of(a).side == cause_of(b).side); });
}

std::size_t ids_in_common(const Label& label, const Answer& answer) {
    return static_cast<std::size_t>(std::count_if(label.effects.begin(), label.effects.end(), [&](const LabelEffect& truth) {
        return std::any_of(answer.effects.begin(), answer.effects.end(), [&](const auto& e) { return e.cause.id == truth.id; });
    }));
}

std::string wrong_name(const Label& label, const Answer& answer) {
    if (answer.verdict == diagnosis::VerdictKind::kNone) return "not seen";
    if (answer.verdict == diagnosis::VerdictKind::kInconclusive) return "called inconclusive";
    if (answer.verdict == diagnosis::VerdictKind::kUnknown) return "called unknown";
    if (answer.verdict == diagnosis::VerdictKind::kAmbiguous)
        return leaves_open(answer, label) ? "left open" : "left open without the truth";
    if (names(answer, label, false)) return "another side";
    const std::size_t right = ids_in_common(label, answer);
    if (right == label.effects.size()) return "one effect too many";
    if (right == 0) return "another effect";
    return label.effects.size() == 2 ? "one of two" : fmt::format("{} of {}", right, label.effects.size());
}

bool misses_a_size(const Label& label, const Answer& answer) {
    return std::any_of(answer.effects.begin(), answer.effects.end(), [&](const diagnosis::FoundEffect& effect) {
        const LabelEffect* truth = found_in(label, effect);
        return truth != nullptr && !effect.parameter.ci95.holds(truth->size);
    });
}

/// Where each outside effect of the plant enters, and on what it depends, in the words of effects::Term.
struct Form {
    const char *id, *port, *depends_on;
};
constexpr std::array kForms{Form{"outside.gear_ripple", "gear", "angle"},
                            Form{"outside.friction_drift", "gear", "time"},
                            Form{"outside.crosstalk", "motor", "other motor"},
                            Form{"outside.cogging", "motor", "angle"},
                            Form{"outside.groove_jump", "cable", "load and time"},
                            Form{"outside.encoder_eccentricity", "capstan encoder", "angle"},
                            Form{"outside.capstan_slip", "cable", "load and time"},
                            Form{"outside.se_crack", "K_SE", "angle"},
                            Form{"outside.pe_crack", "K_PE", "angle"},
                            Form{"outside.pe_creep", "K_PE", "time"},
                            Form{"outside.harness", "joint", "angle"},
                            Form{"outside.joint_rough_spot", "joint", "angle"},
                            Form{"outside.eccentric_pulley", "joint", "angle"},
                            Form{"outside.joint_flexibility", "joint encoder", "load"},
                            Form{"outside.clock_skew", "joint encoder", "time"},
                            Form{"outside.encoder_scale", "joint encoder", "angle"},
                            Form{"outside.motor_fade", "motor", "time"},
                            Form{"outside.thermal_spring", "K_SE", "time"},
                            Form{"outside.magnetic_saturation", "motor", "torque"},
                            Form{"outside.friction_rise", "gear", "speed"},
                            Form{"outside.zero_drift", "joint encoder", "time"},
                            Form{"outside.joint_encoder_eccentricity", "joint encoder", "angle"},
                            Form{"outside.quadratic_drag", "joint", "speed"},
                            Form{"outside.mount", "cable", "load"},
                            Form{"outside.joint_play", "joint encoder", "history"}};

/// Where an effect of the library enters: by its id, or by the part that the id begins with.
constexpr std::array kPlaces{std::pair{"sensor.torque_scale", "motor"},
                             std::pair{"sensor.joint_offset", "joint encoder"},
                             std::pair{"gear.backlash", "capstan encoder"},
                             std::pair{"cable.tension_friction", "joint"},
                             std::pair{"figure.motor_viscous", "gear"},
                             std::pair{"figure.motor_inertia", "motor"},
                             std::pair{"figure.joint_radius", "joint"},
                             std::pair{"figure.joint_inertia", "joint"},
                             std::pair{"figure.joint_viscous", "joint"},
                             std::pair{"gear.", "gear"},
                             std::pair{"motor.", "motor"},
                             std::pair{"loop.", "motor"},
                             std::pair{"cable.", "cable"},
                             std::pair{"se.", "K_SE"},
                             std::pair{"pe.", "K_PE"},
                             std::pair{"joint.", "joint"}};

std::string_view place_of(std::string_view id) {
    const auto found = std::find_if(kPlaces.begin(), kPlaces.end(), [&](const auto& place) { return id.starts_with(place.first); });
    return found == kPlaces.end() ? std::string_view() : found->second;
}

const Form& form_of(const Label& label) {
    const auto found = std::find_if(kForms.begin(), kForms.end(), [&](const Form& form) { return form.id == label.effects.front().id; });
    if (found == kForms.end()) throw core::InvalidInput("effect", label.effects.front().id, "an outside effect whose form is known");
    return *found;
}

}  // namespace

bool has_port(const Answer& answer, const Label& label) { return !answer.form.empty() && answer.form.front().port == form_of(label).port; }

bool has_dependence(const Answer& answer, const Label& label) {
    return !answer.form.empty() && answer.form.front().depends_on == form_of(label).depends_on;
}

std::size_t misplaced(const Answer& answer, const Label& label) {
    if (!has_name(answer)) return 0;
    return static_cast<std::size_t>(std::count_if(answer.effects.begin(), answer.effects.end(),
                                                  [&](const auto& e) { return place_of(e.cause.id) != form_of(label).port; }));
}

bool tells_place(const Answer& answer, const Label& label) {
    return has_port(answer, label) || (has_name(answer) && !answer.effects.empty() && misplaced(answer, label) == 0);
}

bool knows_effects(const Label& label) { return label.in_library && !label.effects.empty(); }

bool has_verdict(const Answer& answer, diagnosis::VerdictKind verdict) { return answer.failure.empty() && answer.verdict == verdict; }

bool has_name(const Answer& answer) {
    return has_verdict(answer, diagnosis::VerdictKind::kIdentified) || has_verdict(answer, diagnosis::VerdictKind::kPartlyExplained);
}

bool names(const Answer& answer, const Label& label, bool sides) { return has_name(answer) && same(label, answer.effects, sides); }

bool leaves_open(const Answer& answer, const Label& label) {
    if (names(answer, label, false)) return true;
    return has_verdict(answer, diagnosis::VerdictKind::kAmbiguous) &&
           (same(label, answer.effects, false) || std::any_of(answer.alternatives.begin(), answer.alternatives.end(),
                                                              [&](const auto& other) { return same(label, other.effects, false); }));
}

bool is_right_in_doubt(const Answer& answer, const Label& label) {
    const bool inconclusive = has_verdict(answer, diagnosis::VerdictKind::kInconclusive);
    if (label.effects.empty()) return inconclusive || has_verdict(answer, diagnosis::VerdictKind::kNone);
    if (inconclusive) return !label.conditions.experiments.empty();
    return has_name(answer) ? names(answer, label, true) : leaves_open(answer, label);
}

bool identifies_a_wrong_effect(const Answer& answer, const Label& label) {
    return has_verdict(answer, diagnosis::VerdictKind::kIdentified) &&
           std::any_of(answer.effects.begin(), answer.effects.end(), [&](const auto& e) { return found_in(label, e) == nullptr; });
}

bool halves_the_gap(const Answer& answer) { return answer.held_out_after <= kEnough * answer.held_out_before; }

const LabelEffect* found_in(const Label& label, const diagnosis::FoundEffect& effect) {
    const auto found =
        std::find_if(label.effects.begin(), label.effects.end(), [&](const LabelEffect& truth) { return cause_of(truth) == effect.cause; });
    return found == label.effects.end() ? nullptr : &*found;
}

std::string miss_of(const Label& label, const Answer& answer) {
    if (!answer.failure.empty()) return "no diagnosis: " + answer.failure;
    const std::string said = answer_name(answer);
    if (!label.in_library) return said == "unknown" ? "" : "from outside, called " + said;
    if (label.effects.empty()) return said == "none" ? "" : "faultless, called " + said;
    std::string what = names(answer, label, true) ? "" : wrong_name(label, answer);
    const auto add = [&](const char* more) { what += (what.empty() ? "" : ", ") + std::string(more); };
    if (misses_a_size(label, answer)) add("interval misses the true size");
    if (!halves_the_gap(answer)) add("held-out gap not halved");
    return what;
}

}  // namespace fusee::blind
