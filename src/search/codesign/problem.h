#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/core/units.h"
#include "fusee/design/robust.h"
#include "fusee/design/search.h"
#include "fusee/profile/profile.h"
#include "variables.h"

namespace fusee::search::codesign {

/// One limit of a design, as measured: a demand, a limit of the search, a rule, or a refusal of law and cam.
struct Limit {
    std::string name;  ///< "demand.travel", "limit.rho k_se" or the rule's id with its part
    std::string unit;
    double measured = 0.0, allowed = 0.0;
    core::Bound bound = core::Bound::kAtLeast;
    bool review = false;  ///< a warning that is accepted
    /// The share by which the limit is broken (above 0) or kept (below), held within [-10, 10]; 10 if `measured` is not a number.
    [[nodiscard]] double excess() const;
};

/// The figures of one candidate without its solids.
struct Trial {
    double violation = 0.0;                 ///< sum of the broken limits' excesses; 0: feasible
    std::vector<Limit> limits;              ///< all that could be measured
    std::vector<double> dead_band;          ///< exact, full width at the joint, at CoDesignOptions::torques [rad]
    std::vector<design::RobustBand> bands;  ///< there too, if CoDesignOptions::figure is kPercentile95
    double figure = 0.0;                    ///< CoDesignOptions::figure of dead_band or bands [rad]
    double travel = 0.0;                    ///< of the capstan, between CoDesignOptions::loads [rad]
    core::Range stiffness;                  ///< of the joint, capstans held, at those loads [Nm/rad]
    double radius = 0.0;                    ///< largest contour radius of both cams, idle arcs included where they could be made [m]
    double arc_radius = 0.0;                ///< the same of the working arcs alone [m]
    [[nodiscard]] bool feasible() const { return violation == 0.0; }
};

/// The cost that is minimised: the figure in degrees, or, if a limit is broken, 1000 (1 + violation), so that every feasible candidate is
/// better than every infeasible one.
[[nodiscard]] double cost(const Trial& trial);

/// The trial as it is if reviews are avoided, and both contours' least radius of curvature is `least_rho` [m]: the same candidate is not
/// measured twice. @pre its reviews were accepted
[[nodiscard]] Trial avoiding_reviews(Trial trial, double least_rho);

/// What an infeasible candidate breaks, the worst first, as findings.
[[nodiscard]] core::Findings broken(const Trial& trial);

/// A design between the searched numbers and a profile.
struct Draft;

/// The co-design of one profile: the searched numbers, the profile of a candidate, and its evaluation. Immutable and reentrant.
class Problem {
public:
    /// Demands left at 0 are taken from the profile's own law.
    /// @throws InvalidInput naming the key; also if a demand would come from a law that cannot be made
    explicit Problem(const profile::Profile& base);
    Problem(const Problem&) = delete;  // the variables refer to the catalogue's rows
    Problem& operator=(const Problem&) = delete;

    [[nodiscard]] std::size_t size() const { return variables_.size(); }
    [[nodiscard]] std::vector<core::Range> bounds() const { return bounds_of(variables_); }
    /// The i-th searched number as a person reads it: rates and stiffnesses are searched by their logarithms.
    struct Shown {
        std::string name, unit;
        core::Range box;
        double value = 0.0;
    };
    [[nodiscard]] Shown show(std::size_t i, double x) const;
    /// Every demand filled in.
    [[nodiscard]] const design::CoDesignOptions& options() const { return base_.co_design; }
    [[nodiscard]] const profile::Profile& base() const { return base_; }

    /// The profile that the numbers stand for, each rounded to 6 digits, so that the judged profile is the written one. @pre x has size()
    [[nodiscard]] profile::Profile candidate(std::span<const double> x) const;
    /// Law, dead-band, contours; then, if nothing is broken so far, cams and every rule that needs no mesh.
    [[nodiscard]] Trial evaluate(std::span<const double> x) const { return evaluate(candidate(x)); }
    [[nodiscard]] Trial evaluate(const profile::Profile& candidate) const;

private:
    void add(
        std::string name, std::string unit, core::Range bounds, std::function<void(Draft&, double)> set,
        double (*shown)(double) = [](double x) { return x; });
    void add_rig();
    void add_spring(profile::PartSpec profile::Profile::*part, const std::string& name, core::Range preload);
    void add_stiction_law();
    void add_free_curve();
    void complete_demands();

    profile::Profile base_;
    std::vector<Variable<Draft>> variables_;
};

}  // namespace fusee::search::codesign
