#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fusee/core/error.h"
#include "fusee/math/roots.h"
#include "fusee/spring/enclosure.h"
#include "fusee/spring/law.h"

namespace fusee::spring {

namespace {

/// One spring's continuation below the start of a law; x in [-travel, 0] (docs/theory/springs.md, eq. 12-14).
struct Tail {
    double force0 = 0.0, stiffness0 = 0.0, slope0 = 0.0, travel = 0.0;

    template <class T>
    [[nodiscard]] T slope(const T& x) const {
        return slope0 * (1.0 + x / travel);
    }
    template <class T>
    [[nodiscard]] T stiffness(const T& x) const {
        return stiffness0 + slope0 * x * (1.0 + 0.5 * x / travel);
    }
    template <class T>
    [[nodiscard]] T force(const T& x) const {
        return force0 + x * (stiffness0 + slope0 * x * (0.5 + x / (6.0 * travel)));
    }
    /// Energy above that at the law's start; below 0.
    template <class T>
    [[nodiscard]] T energy(const T& x) const {
        return x * (force0 + x * (0.5 * stiffness0 + slope0 * x * (1.0 / 6.0 + x / (24.0 * travel))));
    }

    /// The travel at which the stiffness or the torque at the lower end reaches zero first.
    [[nodiscard]] double longest_travel() const {
        constexpr double kNone = std::numeric_limits<double>::infinity();
        const double by_stiffness = slope0 > 0.0 ? 2.0 * stiffness0 / slope0 : kNone;
        // force(-travel) = force0 - stiffness0 travel + slope0 travel^2/3 = 0, its smaller positive root
        const double root = stiffness0 * stiffness0 - 4.0 / 3.0 * slope0 * force0;
        const double by_force = root >= 0.0 ? 2.0 * force0 / (stiffness0 + std::sqrt(root)) : kNone;
        return std::min(by_stiffness, by_force);
    }
};

class LeadInLaw final : public SpringLaw, public EnclosedLaw {
public:
    LeadInLaw(SpringLawPtr law, const Tail& series, const Tail& parallel)
        : law_(std::move(law)), series_(series), parallel_(parallel), travel_(series.travel), start_(law_->loads().low) {}

    [[nodiscard]] core::Range loads() const override { return {load_at(-travel_), law_->loads().high}; }
    [[nodiscard]] core::Range angles() const override { return {0.0, travel_ + law_->angles().high}; }

    [[nodiscard]] LawPoint at_load(double tau) const override {
        if (tau >= start_) return lifted(law_->at_load(tau));
        const double load = std::max(tau, load_at(-travel_));
        const auto x = math::bracketed_root([&](double at) { return load_at(at) - load; }, -travel_, 0.0);
        LawPoint point = tail_point<LawPoint>(x.value_or(0.0));  // no root only if rounding puts `load` above the junction
        point.tau = load;
        return point;
    }

    [[nodiscard]] LawPoint at_angle(double theta) const override {
        if (theta >= travel_) return lifted(law_->at_angle(theta - travel_));
        return tail_point<LawPoint>(std::max(theta, 0.0) - travel_);
    }
    /// The lead-in by its deflection x, then the segments of the law.
    [[nodiscard]] std::vector<LawSegment> segments() const override {
        std::vector<LawSegment> result = spring::segments(*law_);
        for (LawSegment& own : result) own.over = [*this, over = own.over](const math::Interval& x) { return lifted(over(x)); };
        if (result.empty()) return {};
        result.insert(result.begin(),
                      {{-travel_, 0.0}, [*this](const math::Interval& x) { return tail_point<LawJet>(math::Jet::parameter(x)); }});
        return result;
    }

private:
    template <class T>
    [[nodiscard]] T load_at(const T& x) const {
        return series_.force(x) + parallel_.force(x);
    }

    /// A point of the law, counted from the lead-in's lower end.
    template <class Point>
    [[nodiscard]] Point lifted(Point point) const {
        point.theta += travel_;
        point.u_se -= series_.energy(-travel_);
        point.u_pe -= parallel_.energy(-travel_);
        return point;
    }

    template <class Point, class T>
    [[nodiscard]] Point tail_point(const T& x) const {
        Point point;
        point.tau = load_at(x);
        point.theta = x + travel_;
        point.f_se = series_.force(x);
        point.f_pe = parallel_.force(x);
        point.s = series_.stiffness(x);
        point.p = parallel_.stiffness(x);
        point.s_slope = series_.slope(x);
        point.p_slope = parallel_.slope(x);
        point.u_se = series_.energy(x) - series_.energy(-travel_);
        point.u_pe = parallel_.energy(x) - parallel_.energy(-travel_);
        return point;
    }

    SpringLawPtr law_;
    Tail series_, parallel_;
    double travel_, start_;
};

core::Finding too_long(const char* spring, double travel, double longest) {
    const double safe = 0.98 * longest;
    core::Finding finding =
        core::error_finding("law.lead_in", fmt::format("{}'s stiffness and torque must stay above 0 over the lead-in", spring),
                            core::deg_from_rad(travel), core::Bound::kAtMost, core::deg_from_rad(longest), "deg");
    finding.where = "lower end of the law's lead-in";
    finding.suggestion = core::change("law.lead_in_deg", core::number(core::deg_from_rad(safe), 4));
    finding.source = "docs/theory/springs.md, eq. 15";
    return finding;
}

}  // namespace

core::Outcome<SpringLawPtr> with_lead_in(SpringLawPtr law, double travel) {
    core::require_within("law.lead_in_deg", core::deg_from_rad(travel), 0.0, std::numeric_limits<double>::max(), "deg");
    if (travel == 0.0) return law;
    const LawPoint start = law->at_angle(0.0);
    const Tail series{start.f_se, start.s, start.s_slope, travel};
    const Tail parallel{start.f_pe, start.p, start.p_slope, travel};
    const bool series_binds = series.longest_travel() <= parallel.longest_travel();
    const double longest = std::min(series.longest_travel(), parallel.longest_travel());
    if (travel >= longest) return too_long(series_binds ? "K_SE" : "K_PE", travel, longest);
    return SpringLawPtr(std::make_shared<LeadInLaw>(std::move(law), series, parallel));
}

}  // namespace fusee::spring
