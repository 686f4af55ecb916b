#include <fmt/format.h>

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/spring/enclosure.h"
#include "fusee/spring/potential.h"

namespace fusee::spring {

namespace {

/// sum_i coefficients[i] x^i by Horner's rule
template <class T>
T sum_of_powers(const std::vector<double>& coefficients, const T& x) {
    T sum = 0.0;
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) sum = sum * x + *c;
    return sum;
}

std::vector<double> derived(const std::vector<double>& coefficients) {
    std::vector<double> result;
    for (std::size_t i = 1; i < coefficients.size(); ++i) result.push_back(static_cast<double>(i) * coefficients[i]);
    return result;
}

std::vector<double> integrated(const std::vector<double>& coefficients) {
    std::vector<double> result{0.0};
    for (std::size_t i = 0; i < coefficients.size(); ++i) result.push_back(coefficients[i] / static_cast<double>(i + 1));
    return result;
}

class Polynomial final : public Potential, public EnclosedPotential {
public:
    explicit Polynomial(std::vector<double> force)
        : energy_(integrated(force)), stiffness_(derived(force)), slope_(derived(stiffness_)), force_(std::move(force)) {}

    [[nodiscard]] core::Range domain() const override { return {0.0, kLongestDeflection}; }
    [[nodiscard]] double energy(double x) const override { return sum_of_powers(energy_, x); }
    [[nodiscard]] double force(double x) const override { return sum_of_powers(force_, x); }
    [[nodiscard]] double stiffness(double x) const override { return sum_of_powers(stiffness_, x); }
    [[nodiscard]] double slope(double x) const override { return sum_of_powers(slope_, x); }
    [[nodiscard]] std::vector<double> breaks() const override { return {domain().low, domain().high}; }
    [[nodiscard]] PotentialJet over(const math::Interval& box) const override {
        const math::Jet x = math::Jet::parameter(box);
        return {sum_of_powers(energy_, x), sum_of_powers(force_, x), sum_of_powers(stiffness_, x), sum_of_powers(slope_, x)};
    }

private:
    std::vector<double> energy_, stiffness_, slope_, force_;
};

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

PotentialPtr make_polynomial(std::vector<double> coefficients) {
    if (coefficients.empty()) throw core::InvalidInput("coefficients", "none", "at least one");
    for (std::size_t i = 0; i < coefficients.size(); ++i)
        if (!std::isfinite(coefficients[i]))
            throw core::InvalidInput(fmt::format("coefficients[{}]", i), fmt::format("{:g}", coefficients[i]), "a finite number");
    return std::make_shared<Polynomial>(std::move(coefficients));
}

PotentialPtr make_exponential(double scale, double rate, double offset) {
    require_number("scale", scale, false);
    require_number("rate", rate, false);
    require_number("offset", offset, true);
    return std::make_shared<Exponential>(scale, rate, offset);
}

}  // namespace fusee::spring
