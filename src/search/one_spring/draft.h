#pragma once
#include <vector>

#include "fusee/pipeline/evaluate.h"
#include "fusee/profile/profile.h"
#include "fusee/search/one_spring.h"
#include "fusee/spring/catalogue.h"
#include "variables.h"

/// What a part of one spring is like, and what a search of the smallest one pays for it.
namespace fusee::search::one_spring {

/// What any part of a law has to do: whatever the family, energy is kept.
struct Task {
    double torque = 0.0;          ///< largest, without sign [Nm]
    core::Range of_first;         ///< least and greatest energy against that at the first angle [J]
    double travel = 0.0;          ///< of the law [rad]
    std::vector<double> torques;  ///< evenly over it [Nm]
    [[nodiscard]] bool has_both_signs() const;
    [[nodiscard]] double taken() const { return -of_first.low; }    ///< out of the spring before the law loads it again [J], >= 0
    [[nodiscard]] double work() const { return of_first.width(); }  ///< between the least and the greatest energy [J]
};
/// Refusal: that of the law. @throws core::InvalidInput naming its key
[[nodiscard]] core::Outcome<Task> task_of(const profile::Profile& profile);

/// The numbers of a part that are searched.
struct Draft {
    double reserve = 1.0;  ///< energy of the preload beyond `taken`, over the law's work
    double arm = 20e-3;    ///< scale of the arms: largest torque over the largest load of cable or roller [m]
    double turn = 3.0;     ///< of a spool over the law [rad]
    double base = 20e-3;   ///< base radius of a roller's rim [m]
    double lever = 1.0;    ///< of the spring on a follower's arm, over the arm's length
    double rib = 1e-3;     ///< flange beside groove or roller's track [m]
    double least = 0.3;    ///< least torque of each of two cables, over the largest
    double back = 1.0;     ///< energy of the preload of the cable that pulls back, over its work
    // What a person has asked for, where it may be changed.
    double width = 0.0;  ///< of the Gaussian that smooths the law, over its travel
    double share = 1.0;  ///< of the law's torques
    double kept = 1.0;   ///< of its travel, from the first angle on
    double bed = 1.0;    ///< sides of the machine's room over those of the profile
};

/// What of it a search may change.
enum class Freedom { kNone, kLaw, kTorque, kRange, kBed };

/// The profile with a part of this family ("spool", "cable", "helix", "two_cables", "roller", "arm"); its base spring has no wire yet.
/// @throws core::InvalidInput(s) if it is not a profile
[[nodiscard]] profile::Profile in_family(const profile::Profile& profile, const std::string& family);

/// The numbers of `Draft` that the family has, in logarithms. @param keeps_pulley the pulley of a spool is the profile's own
[[nodiscard]] std::vector<Variable<Draft>> variables_of(const std::string& family, const profile::Profile& profile, const Task& task,
                                                        bool keeps_pulley, Freedom freedom = Freedom::kNone);

/// The profile of a draft, its numbers rounded as they are written. @param sold of its kind, of which it takes that of the nearest rate;
/// empty: a spring of any rate
[[nodiscard]] profile::Profile drawn(profile::Profile profile, const Draft& draft, const Task& task, bool keeps_pulley,
                                     const std::vector<spring::CatalogueSpring>& sold = {});
/// That of the nearest rate. @pre sold is not empty
[[nodiscard]] const spring::CatalogueSpring& nearest_sold(const std::vector<spring::CatalogueSpring>& sold, double rate);

inline constexpr double kRefused = 1e3;  ///< least cost of a draft that breaks a rule

/// A measure of that room, below 1, or at least `kRefused`: how far the draft is from being a part.
[[nodiscard]] double cost_of(const pipeline::Evaluation& seen, const profile::Profile& draft);

/// A draft as a part of a front, both parts of two cables one on the other. @pre it passed @param torque largest of the law, without sign
/// [Nm]
[[nodiscard]] Family::Candidate candidate_of(const pipeline::Evaluation& seen, const profile::Profile& draft, double torque);

/// The same of a profile whose spring is known. @pre solids
[[nodiscard]] Figures figures_of(const pipeline::Evaluation& seen, const profile::Profile& profile, double torque);

}  // namespace fusee::search::one_spring
