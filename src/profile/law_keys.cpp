#include "key.h"

namespace fusee::profile {

namespace {

constexpr const char* kKindKey = "law.kind";
constexpr const char *kStiction = "stiction_compensating", *kPolynomial = "polynomial", *kExponential = "exponential", *kTable = "table",
                     *kFromDeadBand = "from_dead_band", *kFreeCurve = "free_curve", *kStiffness = "stiffness", *kFormula = "formula",
                     *kPoints = "points";
constexpr const char *kDeadBandFile = "law.dead_band_file", *kSeriesFile = "law.series_stiffness_file",
                     *kSeriesFormula = "law.series_stiffness_Nm_per_rad";

const std::vector<std::string> kPairs{kStiction, kPolynomial, kExponential, kTable, kFromDeadBand, kFreeCurve};  // as LawSpec::curves
const std::vector<std::string> kOnes{"constant", "gravity", kPolynomial, kExponential,
                                     kStiffness, kFormula,  kPoints,     kTable};  // as OneSpring::Kind

void set_pair(Profile& p, const std::string& name) {
    if (name == kStiction) p.law.curves = spring::StictionLawOptions{};
    if (name == kPolynomial) p.law.curves = PolynomialPair{};
    if (name == kExponential) p.law.curves = ExponentialPair{};
    if (name == kTable) p.law.curves = TablePair{};
    if (name == kFromDeadBand) p.law.curves = DeadBandSpec{};
    if (name == kFreeCurve) p.law.curves = spring::FreeCurveOptions{};
}

/// Chooses the alternative of LawSpec::curves, or the kind of a single spring.
Key law_kind(Key::Of of) {
    const bool one = of == Key::Of::kSpring;
    Key key;
    key.path = kKindKey;
    key.kind = Kind::kChoice;
    key.of = of;
    key.meaning = one ? "kind of the torque over the angle; selects the keys below" : "kind of the pair of springs; selects the keys below";
    key.choices = one ? kOnes : kPairs;
    key.required = true;
    key.get = [](const Profile& p) {
        const auto* spring = std::get_if<OneSpring>(&p.law.curves);
        return Value(spring ? kOnes.at(static_cast<std::size_t>(spring->kind)) : kPairs.at(p.law.curves.index()));
    };
    key.set = [](Profile& p, const Value& v) {
        const std::string& name = std::get<std::string>(v);
        if (auto* spring = std::get_if<OneSpring>(&p.law.curves))
            spring->kind = static_cast<OneSpring::Kind>(std::find(kOnes.begin(), kOnes.end(), name) - kOnes.begin());
        else
            set_pair(p, name);
    };
    return key;
}

#define OF(alternative, member) \
    [](auto& p) -> auto& { return std::get<alternative>(p.law.curves).member; }

std::vector<Key> curve_keys() {
    using Stiction = spring::StictionLawOptions;
    const Limits torque = within(-1e4, 1e4), coefficient = within(-1e6, 1e6);
    const auto stiction = [](Key key) { return when(kKindKey, {kStiction}, required(std::move(key))); };
    const auto polynomial = [](Key key) { return when(kKindKey, {kPolynomial}, required(std::move(key))); };
    const auto exponential = [](Key key) { return when(kKindKey, {kExponential}, required(std::move(key))); };
    const auto table = [](Key key) { return when(kKindKey, {kTable}, std::move(key)); };
    return {
        stiction(number("law.k_per_Nm_rad", above(0, 1e6), "k of S = k tau^2", OF(Stiction, k))),
        stiction(number("law.u_Nm", within(0, 1e3), "u, rate at which co-contraction shrinks the dead-band", OF(Stiction, u))),
        stiction(number("law.c_Nm", within(-1e3, 1e3), "C, constant of integration: T = u^2/(mu tau^2) + C/tau", OF(Stiction, c))),
        polynomial(numbers("law.series_Nm", coefficient, 1, 12, "K_SE: c_i of F(x) = sum c_i x^i, x = capstan angle in rad",
                           OF(PolynomialPair, series))),
        polynomial(numbers("law.parallel_Nm", coefficient, 1, 12, "K_PE: the same", OF(PolynomialPair, parallel))),
        exponential(number("law.series_scale_Nm", torque, "K_SE: a of F(x) = a (exp(b x) - 1) + c", OF(ExponentialPair, series.scale))),
        exponential(number("law.series_rate_per_rad", within(-1e3, 1e3), "K_SE: b", OF(ExponentialPair, series.rate))),
        exponential(number("law.series_offset_Nm", torque, "K_SE: c", OF(ExponentialPair, series.offset))),
        exponential(number("law.parallel_scale_Nm", torque, "K_PE: a", OF(ExponentialPair, parallel.scale))),
        exponential(number("law.parallel_rate_per_rad", within(-1e3, 1e3), "K_PE: b", OF(ExponentialPair, parallel.rate))),
        exponential(number("law.parallel_offset_Nm", torque, "K_PE: c", OF(ExponentialPair, parallel.offset))),
        table(required(file("law.file", "CSV in the profile's folder: angle_rad,series_Nm,parallel_Nm", OF(TablePair, file)))),
        table(integer("law.knots", within(4, 400), "intervals of the smoothing spline", OF(TablePair, smoothing.knots))),
        table(number("law.smoothing", within(-1, 1e9), "weight of the roughness penalty; below 0: by cross-validation",
                     OF(TablePair, smoothing.smoothing))),
    };
}

/// Springs given by a wanted result: their dead-band, or stiffness and transmission over the load.
std::vector<Key> wish_keys() {
    const auto wanted = [](Key key) { return when(kKindKey, {kFromDeadBand}, std::move(key)); };
    const auto curve = [](Key key) { return when(kKindKey, {kFreeCurve}, required(std::move(key))); };
    const auto no_file = [](const char* other, Key key) { return when(other, {""}, std::move(key)); };
    using Free = spring::FreeCurveOptions;
    return {
        wanted(file(kDeadBandFile, "wanted dead-band: CSV in the profile's folder with tau_Nm,dead_band_deg",
                    OF(DeadBandSpec, dead_band.rows.file))),
        wanted(no_file(kDeadBandFile,
                       required(formula("law.dead_band_deg", "the same as a formula in tau [Nm]: full width at the joint, linear",
                                        OF(DeadBandSpec, dead_band.formula))))),
        wanted(file(kSeriesFile, "S, stiffness of K_SE: CSV in the profile's folder with tau_Nm,stiffness_Nm_per_rad",
                    OF(DeadBandSpec, series_stiffness.rows.file))),
        wanted(no_file(kSeriesFile, formula(kSeriesFormula, "S as a formula in tau [Nm]; neither: chosen, S = k tau^2",
                                            OF(DeadBandSpec, series_stiffness.formula)))),
        wanted(no_file(kSeriesFile, no_file(kSeriesFormula,
                                            number("law.start_transmission", above(0, 0.999), "T at the start torque, from which k follows",
                                                   OF(DeadBandSpec, start_transmission))))),
        curve(numbers("law.loads_Nm", above(0, 1e4), 4, 100, "knots of the free curve, rising; the first and the last are the law's ends",
                      OF(Free, loads))),
        curve(numbers("law.series_Nm_per_rad", above(0, 1e6), 4, 100, "S, stiffness of K_SE, at each knot", OF(Free, series_stiffness))),
        curve(numbers("law.transmission", above(0, 0.999), 4, 100, "T = S/(S+P) at each knot", OF(Free, transmission))),
    };
}

}  // namespace

std::vector<Key> law_keys() {
    std::vector<Key> all = core::joined(std::vector{law_kind(Key::Of::kJoint)}, curve_keys(), wish_keys());
    const auto with_ends = [](Key key) {
        return when(kKindKey, {kStiction, kPolynomial, kExponential, kTable, kFromDeadBand}, required(std::move(key)));
    };
    all.push_back(
        with_ends(number("law.start_torque_Nm", above(0, 1e4), "lowest load of the law without lead-in", FIELD(law.start_torque))));
    all.push_back(with_ends(number("law.end_torque_Nm", above(0, 1e4), "highest load; above overdrive torque / (1 - mu) to cover stiction",
                                   FIELD(law.end_torque))));
    all.push_back(
        number("law.lead_in_deg", within(0, 720), "capstan travel of the low-load law below the start", FIELD(law.lead_in_travel)));
    return all;
}

std::vector<Key> one_spring_keys() {
    const Limits torque = within(-1e5, 1e5), coefficient = within(-1e6, 1e6), angle = within(-1e5, 1e5);
    const auto only = [](const char* kind, Key key) { return when(kKindKey, {kind}, required(std::move(key))); };
    const auto ranged = [](Key key) {
        return when(kKindKey, {"constant", "gravity", kPolynomial, kExponential, kStiffness, kFormula}, required(std::move(key)));
    };
    const auto table = [](Key key) { return when(kKindKey, {kTable}, std::move(key)); };
    const std::string in_x = " as a formula in x, the angle [rad]";
    std::vector<Key> all{
        law_kind(Key::Of::kSpring),
        ranged(number("law.from_deg", angle, "first angle of the law, where the spring has its preload", OF(OneSpring, angles.low))),
        ranged(number("law.to_deg", angle, "last angle", OF(OneSpring, angles.high))),
        only("constant", number("law.torque_Nm", torque, "the torque", OF(OneSpring, torque))),
        only("gravity", number("law.mass_kg", above(0, 1e5), "m of m g l sin(angle)", OF(OneSpring, mass))),
        only("gravity",
             number("law.lever_mm", above(0, 1e5), "l, axis to centre of gravity; angle 0: straight above the axis", OF(OneSpring, lever))),
        only(kPolynomial, numbers("law.coefficients_Nm", coefficient, 1, 12, "c_i of F(x) = sum c_i x^i, x = angle in rad",
                                  OF(OneSpring, coefficients))),
        only(kExponential, number("law.scale_Nm", torque, "a of F(x) = a (exp(b x) - 1) + c", OF(OneSpring, exponential.scale))),
        only(kExponential, number("law.rate_per_rad", within(-1e3, 1e3), "b", OF(OneSpring, exponential.rate))),
        only(kExponential, number("law.offset_Nm", torque, "c", OF(OneSpring, exponential.offset))),
        only(kStiffness, formula("law.stiffness_Nm_per_rad", "dF/dx" + in_x, OF(OneSpring, formula))),
        only(kStiffness, number("law.first_torque_Nm", torque, "the torque at the first angle", OF(OneSpring, torque))),
        only(kFormula, formula("law.formula_Nm", "the torque" + in_x, OF(OneSpring, formula))),
        only(kPoints, numbers("law.angles_deg", angle, 4, 200, "rising; the curve goes through every point", OF(OneSpring, rows.x))),
        only(kPoints, numbers("law.torques_Nm", torque, 4, 200, "at each angle", OF(OneSpring, rows.y))),
        table(required(file("law.file", "CSV in the profile's folder: angle_rad,torque_Nm", OF(OneSpring, rows.file)))),
        table(integer("law.knots", within(4, 400), "intervals of the smoothing spline", OF(OneSpring, smoothing.knots))),
        table(number("law.smoothing", within(-1, 1e9), "weight of the roughness penalty; below 0: by cross-validation",
                     OF(OneSpring, smoothing.smoothing))),
    };
    return all_of(Key::Of::kSpring, std::move(all));
}

#undef OF

}  // namespace fusee::profile
