#pragma once
#include <functional>
#include <vector>

#include "fusee/math/interval.h"
#include "fusee/spring/law.h"
#include "fusee/spring/potential.h"

/// Bounds of laws over whole ranges, by the same formulas as their points; `cam::certify` proves with them.
namespace fusee::spring {

/// Every figure of a `LawPoint` over a box of some parameter, with its derivative by that parameter.
struct LawJet {
    math::Jet tau, theta, f_se, f_pe, s, p, s_slope, p_slope, u_se, u_pe;
};

/// A segment of a law that is one smooth formula of one parameter: the load [Nm] or a deflection [rad], whichever gives its points without
/// solving an equation. Both rise together.
struct LawSegment {
    core::Range parameter;
    std::function<LawJet(const math::Interval&)> over;  ///< @pre the box lies in `parameter`; thread-safe
};

/// A `SpringLaw` with bounds.
class EnclosedLaw {
public:
    virtual ~EnclosedLaw() = default;
    /// The segments by rising load; each begins at the end of the previous one. Empty if a part of the law has no bounds.
    [[nodiscard]] virtual std::vector<LawSegment> segments() const = 0;
};
/// Empty if the law has no bounds.
[[nodiscard]] std::vector<LawSegment> segments(const SpringLaw& law);

/// A potential's figures over a box of deflections; the last slope is U''''.
struct PotentialJet {
    math::Jet energy, force, stiffness, slope;
};

/// A `Potential` with bounds.
class EnclosedPotential {
public:
    virtual ~EnclosedPotential() = default;
    /// Boundaries of its formulas [rad], ascending, the ends of the domain included.
    [[nodiscard]] virtual std::vector<double> breaks() const = 0;
    /// @pre the box lies between two neighbouring breaks
    [[nodiscard]] virtual PotentialJet over(const math::Interval& x) const = 0;
};

/// The ends of `range` and those of `places` inside it, ascending, each once.
[[nodiscard]] std::vector<double> cuts(core::Range range, const std::vector<double>& places);

}  // namespace fusee::spring
