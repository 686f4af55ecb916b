#include "key.h"

namespace fusee::profile {

namespace {

constexpr const char* kKindKey = "law.kind";
constexpr const char *kStiction = "stiction_compensating", *kPolynomial = "polynomial", *kExponential = "exponential", *kTable = "table";

/// Chooses the alternative of LawSpec::curves; the names stand in the variant's order.
Key law_kind() {
    Key key;
    key.path = kKindKey;
    key.kind = Kind::kChoice;
    key.meaning = "how the pair of springs is given; brings its own keys below";
    key.choices = {kStiction, kPolynomial, kExponential, kTable};
    key.required = true;
    key.get = [names = key.choices](const Profile& p) { return Value(names.at(p.law.curves.index())); };
    key.set = [](Profile& p, const Value& v) {
        const std::string& name = std::get<std::string>(v);
        if (name == kStiction) p.law.curves = spring::StictionLawOptions{};
        if (name == kPolynomial) p.law.curves = PolynomialPair{};
        if (name == kExponential) p.law.curves = ExponentialPair{};
        if (name == kTable) p.law.curves = TablePair{};
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
        stiction(number("law.k_per_Nm_rad", kPerNmRad, above(0, 1e6), "k of S = k tau^2", OF(Stiction, k))),
        stiction(number("law.u_Nm", kNm, within(0, 1e3), "u, rate at which co-contraction shrinks the dead-band", OF(Stiction, u))),
        stiction(number("law.c_Nm", kNm, within(-1e3, 1e3), "C, constant of integration: T = u^2/(mu tau^2) + C/tau", OF(Stiction, c))),
        polynomial(numbers("law.series_Nm", kNm, coefficient, 1, 12, "K_SE: c_i of F(x) = sum c_i x^i, x = capstan angle in rad",
                           OF(PolynomialPair, series))),
        polynomial(numbers("law.parallel_Nm", kNm, coefficient, 1, 12, "K_PE: the same", OF(PolynomialPair, parallel))),
        exponential(
            number("law.series_scale_Nm", kNm, torque, "K_SE: a of F(x) = a (exp(b x) - 1) + c", OF(ExponentialPair, series.scale))),
        exponential(number("law.series_rate_per_rad", kPerRad, within(-1e3, 1e3), "K_SE: b", OF(ExponentialPair, series.rate))),
        exponential(number("law.series_offset_Nm", kNm, torque, "K_SE: c", OF(ExponentialPair, series.offset))),
        exponential(number("law.parallel_scale_Nm", kNm, torque, "K_PE: a", OF(ExponentialPair, parallel.scale))),
        exponential(number("law.parallel_rate_per_rad", kPerRad, within(-1e3, 1e3), "K_PE: b", OF(ExponentialPair, parallel.rate))),
        exponential(number("law.parallel_offset_Nm", kNm, torque, "K_PE: c", OF(ExponentialPair, parallel.offset))),
        table(required(plain_key<std::string>(
            "law.file", Kind::kFile, "CSV beside the profile: angle_rad,series_Nm,parallel_Nm",
            [](auto& p) -> auto& { return std::get<TablePair>(p.law.curves).file; }))),
        table(integer("law.knots", within(4, 400), "intervals of the smoothing spline", OF(TablePair, smoothing.knots))),
        table(number("law.smoothing", kPure, within(-1, 1e9), "weight of the roughness penalty; below 0: by cross-validation",
                     OF(TablePair, smoothing.smoothing))),
    };
}

}  // namespace

std::vector<Key> law_keys() {
    std::vector<Key> all{law_kind()};
    for (Key& key : curve_keys()) all.push_back(std::move(key));
    all.push_back(required(number(
        "law.start_torque_Nm", kNm, above(0, 1e4), "lowest load of the law, lead-in not counted",
        [](auto& p) -> auto& { return p.law.start_torque; })));
    all.push_back(required(number(
        "law.end_torque_Nm", kNm, above(0, 1e4), "highest load; to cover stiction: somewhat more than overdrive torque / (1 - mu)",
        [](auto& p) -> auto& { return p.law.end_torque; })));
    all.push_back(number(
        "law.lead_in_deg", kDeg, within(0, 720), "capstan travel of the low-load law below the start",
        [](auto& p) -> auto& { return p.law.lead_in_travel; }));
    return all;
}

#undef OF

}  // namespace fusee::profile
