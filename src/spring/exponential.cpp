#include <fmt/format.h>

#include <cmath>

#include "fusee/core/error.h"
#include "fusee/spring/potential.h"

namespace fusee::spring {

namespace {

class Exponential final : public Potential {
public:
    Exponential(double scale, double rate, double offset) : scale_(scale), rate_(rate), offset_(offset) {}

    [[nodiscard]] core::Range domain() const override { return {0.0, kLongestDeflection}; }
    // expm1 keeps the digits where rate x is small.
    [[nodiscard]] double energy(double x) const override { return scale_ * (std::expm1(rate_ * x) / rate_ - x) + offset_ * x; }
    [[nodiscard]] double force(double x) const override { return scale_ * std::expm1(rate_ * x) + offset_; }
    [[nodiscard]] double stiffness(double x) const override { return scale_ * rate_ * std::exp(rate_ * x); }
    [[nodiscard]] double slope(double x) const override { return rate_ * stiffness(x); }

private:
    double scale_, rate_, offset_;
};

void require_finite(const char* field, double value, bool may_be_zero) {
    if (!std::isfinite(value) || (value == 0.0 && !may_be_zero))
        throw core::InvalidInput(field, fmt::format("{:g}", value), may_be_zero ? "a finite number" : "a finite number other than 0");
}

}  // namespace

PotentialPtr make_exponential(double scale, double rate, double offset) {
    require_finite("scale", scale, false);
    require_finite("rate", rate, false);
    require_finite("offset", offset, true);
    return std::make_shared<Exponential>(scale, rate, offset);
}

}  // namespace fusee::spring
