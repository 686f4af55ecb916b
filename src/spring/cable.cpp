#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cstdint>

#include "fusee/core/error.h"
#include "fusee/spring/potential.h"

namespace fusee::spring {

namespace {

using Member = double LawPoint::*;

/// One spring of a law, by the members of a law's point that belong to it.
class LawSpring final : public Potential {
public:
    LawSpring(SpringLawPtr law, Member energy, Member force, Member stiffness, Member slope)
        : law_(std::move(law)), energy_(energy), force_(force), stiffness_(stiffness), slope_(slope) {}

    [[nodiscard]] core::Range domain() const override { return law_->angles(); }
    [[nodiscard]] double energy(double x) const override { return at(x).*energy_; }
    [[nodiscard]] double force(double x) const override { return at(x).*force_; }
    [[nodiscard]] double stiffness(double x) const override { return at(x).*stiffness_; }
    [[nodiscard]] double slope(double x) const override { return at(x).*slope_; }

private:
    /// Who looks for an equilibrium asks for force and stiffness of one deflection, on both sides of a joint in turn: two points are kept.
    [[nodiscard]] const LawPoint& at(double x) const {
        struct Last {
            std::uint64_t spring = 0;
            double x = 0.0;
            LawPoint point;
        };
        thread_local std::array<std::array<Last, 2>, 8> all;
        auto& [last, before] = all[number_ % all.size()];
        if (before.spring == number_ && before.x == x) return before.point;
        if (last.spring == number_ && last.x == x) return last.point;
        before = last;
        last = {number_, x, law_->at_angle(x)};
        return last.point;
    }

    static inline std::atomic<std::uint64_t> count = 0;
    std::uint64_t number_ = ++count;  ///< no other spring has it, nor had it
    SpringLawPtr law_;
    Member energy_, force_, stiffness_, slope_;
};

/// A spring with its stop below and its straight continuation above. The energy is continuous.
class BehindCable final : public Potential {
public:
    BehindCable(PotentialPtr spring, double stop_travel)
        : spring_(std::move(spring)),
          domain_(spring_->domain()),
          slack_(domain_.low - stop_travel),
          preload_(spring_->force(domain_.low)),
          stop_stiffness_(preload_ / stop_travel),
          slack_energy_(spring_->energy(domain_.low) - 0.5 * preload_ * stop_travel),
          end_energy_(spring_->energy(domain_.high)),
          end_force_(spring_->force(domain_.high)),
          end_stiffness_(spring_->stiffness(domain_.high)) {}

    [[nodiscard]] core::Range domain() const override { return domain_; }

    [[nodiscard]] double energy(double x) const override {
        if (x < slack_) return slack_energy_;
        if (x < domain_.low) return slack_energy_ + 0.5 * stop_stiffness_ * (x - slack_) * (x - slack_);
        if (x <= domain_.high) return spring_->energy(x);
        const double beyond = x - domain_.high;
        return end_energy_ + beyond * (end_force_ + 0.5 * end_stiffness_ * beyond);
    }
    [[nodiscard]] double force(double x) const override {
        if (x < slack_) return 0.0;
        if (x < domain_.low) return stop_stiffness_ * (x - slack_);
        return x <= domain_.high ? spring_->force(x) : end_force_ + end_stiffness_ * (x - domain_.high);
    }
    [[nodiscard]] double stiffness(double x) const override {
        if (x < slack_) return 0.0;
        if (x < domain_.low) return stop_stiffness_;
        return x <= domain_.high ? spring_->stiffness(x) : end_stiffness_;
    }
    [[nodiscard]] double slope(double x) const override { return domain_.holds(x) ? spring_->slope(x) : 0.0; }

private:
    PotentialPtr spring_;
    core::Range domain_;
    double slack_;    ///< deflection below which the cable is slack [rad]
    double preload_;  ///< torque at the stop [Nm]
    double stop_stiffness_, slack_energy_;
    double end_energy_, end_force_, end_stiffness_;
};

}  // namespace

PotentialPtr series_spring(SpringLawPtr law) {
    return std::make_shared<LawSpring>(std::move(law), &LawPoint::u_se, &LawPoint::f_se, &LawPoint::s, &LawPoint::s_slope);
}

PotentialPtr parallel_spring(SpringLawPtr law) {
    return std::make_shared<LawSpring>(std::move(law), &LawPoint::u_pe, &LawPoint::f_pe, &LawPoint::p, &LawPoint::p_slope);
}

PotentialPtr behind_cable(PotentialPtr spring, double stop_travel) {
    core::require_positive("stop_travel", stop_travel, "rad");
    const double preload = spring->force(spring->domain().low);
    if (!(preload >= 0.0))
        throw core::InvalidInput("spring", fmt::format("{:.6g} Nm at its lower end", preload), "at least 0: a cable cannot push");
    return std::make_shared<BehindCable>(std::move(spring), stop_travel);
}

}  // namespace fusee::spring
