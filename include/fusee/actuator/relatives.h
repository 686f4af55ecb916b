#pragma once
#include <string>
#include <vector>

#include "fusee/actuator/joint.h"
#include "fusee/core/finding.h"

namespace fusee::actuator {

/// The joints that the paper names (introduction and section II), all as springs between two motors, output and ground
/// (networks and sources: docs/theory/relatives.md).
enum class Arrangement {
    kPnrvsa,            ///< the paper's: K_SE to the joint, K_PE to ground, both sides
    kSeriesElastic,     ///< one motor, one spring (Pratt 2002)
    kSimpleAntagonist,  ///< two motors, K_SE only: the paper's without K_PE
    kQuasiAntagonist,   ///< DLR QA-joint (Eiberger 2010): motor 1 moves the joint, motor 2 presses two opposed springs together
    kBidirectional,     ///< DLR BAVS (Petit 2010): each motor pulls and pushes the joint through its own pair of springs
    kCrossCoupled,      ///< VSA of Pisa (Tonietti 2005): K_SE on both sides and a third spring between the motors
};
[[nodiscard]] const char* to_string(Arrangement arrangement);  ///< "pnrvsa", "series_elastic", ...

struct ArrangementOptions {
    Arrangement arrangement = Arrangement::kPnrvsa;
    spring::PotentialPtr series,
        parallel;  ///< `parallel` is K_PE (pnrvsa) or the motors' cross spring (may be left out); unused by the rest
    spring::FrictionLaw gear_friction = spring::FrictionLaw::proportional(0.28);
    double capstan_radius = 0.0, joint_radius = 0.0;  ///< [m]
    double position_stiffness = 0.0;  ///< of a position loop at each motor, a spring to ground [Nm/rad]; 0: torque control, as in the paper
    double cross_stretch = 1.0;       ///< stretch of the cross spring at z = 0: the belt's pretension [rad]
};
/// Springs that can only pull are behind cables; those that pull and push are odd in their deflection.
/// A position loop is another spring; it counts as load of its gear when the joint is moved with friction, but not in `survey`.
/// @throws InvalidInput naming the member
[[nodiscard]] Joint make_arrangement(const ArrangementOptions& options);

/// One row of the table that compares them. The level is the torque that stiffens the joint: of both motors (of the one motor of a series
/// elastic joint, balanced at the output; of the second motor of a quasi-antagonist).
struct ArrangementRow {
    Arrangement arrangement = Arrangement::kPnrvsa;
    core::Range stiffness;       ///< passive joint stiffness, motors' gears held, least and greatest [Nm/rad]
    core::Range free_stiffness;  ///< motors free to move under constant torque [Nm/rad]; 0: no path to ground
    double torque = 0.0;         ///< greatest joint torque with each series spring between its torques at the least and greatest level [Nm]
    core::Range dead_band;       ///< linear, full width at the joint, at least and greatest level [rad]; infinite: neutral everywhere
    std::string remark;
};
/// @param cocontraction least and greatest level, both > 0 [Nm]
/// @throws InvalidInput naming the member, or the level at which a spring leaves its law
[[nodiscard]] ArrangementRow survey(const ArrangementOptions& options, core::Range cocontraction);

}  // namespace fusee::actuator
