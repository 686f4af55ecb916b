#pragma once
#include <functional>
#include <vector>

#include "fusee/math/interval.h"
#include "fusee/spring/law.h"
#include "fusee/spring/potential.h"

/// Bounds of laws over whole ranges, by the same formulas that give their points: what `cam::certify` proves with.
namespace fusee::spring {

/// Every figure of a `LawPoint` over a box of some parameter, with its derivative by that parameter.
struct LawJet {
    math::Jet tau, theta, f_se, f_pe, s, p, s_slope, p_slope, u_se, u_pe;
};

/// A stretch of a law over which it is one smooth formula of one parameter: the load [Nm] or a deflection [rad], whichever names its points
/// without solving for them. Both rise together.
struct LawStretch {
    core::Range parameter;
    std::function<LawJet(const math::Interval&)> over;  ///< @pre the box lies in `parameter`; thread-safe
};

/// What a law adds to `SpringLaw` that can say its bounds.
class EnclosedLaw {
public:
    virtual ~EnclosedLaw() = default;
    /// By rising load, each beginning where the one before ends; empty if something that the law is made of cannot say its bounds.
    [[nodiscard]] virtual std::vector<LawStretch> stretches() const = 0;
};
/// Empty if the law cannot say its bounds.
[[nodiscard]] std::vector<LawStretch> stretches(const SpringLaw& law);

/// A potential's figures over a box of deflections; the last slope is U''''.
struct PotentialJet {
    math::Jet energy, force, stiffness, slope;
};

/// What a potential adds to `Potential` that can say its bounds.
class EnclosedPotential {
public:
    virtual ~EnclosedPotential() = default;
    /// Deflections where its formulas meet, ascending, the ends of the domain included.
    [[nodiscard]] virtual std::vector<double> breaks() const = 0;
    /// @pre the box lies between two neighbouring breaks
    [[nodiscard]] virtual PotentialJet over(const math::Interval& x) const = 0;
};

/// Ascending places, each once: those of `range`'s ends and of `places` that lie inside.
[[nodiscard]] std::vector<double> cuts(core::Range range, const std::vector<double>& places);

}  // namespace fusee::spring
