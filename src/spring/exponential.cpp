#include <fmt/format.h>

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/spring/enclosure.h"
#include "fusee/spring/potential.h"

namespace fusee::spring {

namespace {

class Exponential final : public Potential, public EnclosedPotential {
public:
    Exponential(double scale, double rate, double offset) : scale_(scale), rate_(rate), offset_(offset) {}

    [[nodiscard]] core::Range domain() const override { return {0.0, kLongestDeflection}; }
    [[nodiscard]] double energy(double x) const override { return energy_at(x); }
    [[nodiscard]] double force(double x) const override { return force_at(x); }
    [[nodiscard]] double stiffness(double x) const override { return stiffness_at(x); }
    [[nodiscard]] double slope(double x) const override { return rate_ * stiffness(x); }
    [[nodiscard]] std::vector<double> breaks() const override { return {domain().low, domain().high}; }
    [[nodiscard]] PotentialJet over(const math::Interval& box) const override {
        const math::Jet x = math::Jet::parameter(box);
        return {energy_at(x), force_at(x), stiffness_at(x), rate_ * stiffness_at(x)};
    }

private:
    // expm1 keeps the digits if rate x is small.
    template <class T>
    [[nodiscard]] T energy_at(const T& x) const {
        using std::expm1;
        return scale_ * (expm1(rate_ * x) / rate_ - x) + offset_ * x;
    }
    template <class T>
    [[nodiscard]] T force_at(const T& x) const {
        using std::expm1;
        return scale_ * expm1(rate_ * x) + offset_;
    }
    template <class T>
    [[nodiscard]] T stiffness_at(const T& x) const {
        using std::exp;
        return scale_ * rate_ * exp(rate_ * x);
    }

    double scale_, rate_, offset_;
};

void require_number(const char* field, double value, bool may_be_zero) {
    if (!std::isfinite(value) || (value == 0.0 && !may_be_zero))
        throw core::InvalidInput(field, fmt::format("{:g}", value), may_be_zero ? "a finite number" : "a finite number other than 0");
}

}  // namespace

PotentialPtr make_exponential(double scale, double rate, double offset) {
    require_number("scale", scale, false);
    require_number("rate", rate, false);
    require_number("offset", offset, true);
    return std::make_shared<Exponential>(scale, rate, offset);
}

}  // namespace fusee::spring
