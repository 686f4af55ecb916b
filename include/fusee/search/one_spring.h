#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/profile/profile.h"
#include "fusee/spring/catalogue.h"

/// The smallest part of each family for the law of a single spring (docs/guides/one-spring.md).
namespace fusee::search::one_spring {

/// What a part is like whose spring need not be wound and whose mesh need not be made.
struct DraftFigures {
    double diameter = 0.0, height = 0.0;  ///< of the smallest cylinder about the axis around the part, or both parts of two cables [m]
    double spring_volume = 0.0;           ///< that the coils of the base spring fill, unloaded, or of both springs [m^3]: not wound, about
    double built_error = 0.0;             ///< 5 to 95 % of springs as built are within +- this share of the largest torque
    double guide_friction = 0.0;  ///< torque that a roller's slide or pivot takes as a dry plain bearing, of the largest; NaN: no roller
    [[nodiscard]] double room() const;  ///< of the part's cylinder and the spring [m^3]
};
/// What a part that can be made is like.
struct Figures : DraftFigures {
    double volume = 0.0;          ///< of the part, full, or of both [m^3]
    double stress_share = 0.0;    ///< greatest stress of the wire over the allowed one
    double fatigue_safety = 0.0;  ///< of the wire; NaN: not judged
};

/// One family of parts.
struct Family {
    std::string name;  ///< "spool", "cable", "helix" (a cable cam of rising groove), "two_cables" (one each way), "roller" (on a slide),
                       ///< "arm" (a roller on one)
    std::optional<profile::Profile> profile = {};  ///< the smallest part that was found, with its spring; none: none was found
    Figures figures = {};                          ///< of that part
    core::Findings findings = {};                  ///< of every rule of that part; without one the limits that bind, the worst first
    std::size_t judged = 0;                        ///< candidates
    /// The law that was changed so that the part can be made, beside the wanted one, at its points; empty: the law as wanted.
    struct ChangedLaw {
        std::vector<double> angle;          ///< [rad]
        std::vector<double> wanted, now;    ///< [Nm]
        double mean = 0.0, greatest = 0.0;  ///< change: root mean square over the angle; largest, without sign [Nm]
    };
    std::optional<ChangedLaw> changed = {};
    /// A part on the front: no other candidate has as little room, error as built and friction. Its spring is not wound, its mesh not made.
    struct Candidate : DraftFigures {
        double rate = 0.0, preload = 0.0;  ///< of the spring [N/m], [m]; of a spool [Nm/rad], [rad]
    };
    std::vector<Candidate> front = {};  ///< with Options::front, of a law as wanted: the smallest first
    /// What alone, by the least change found, would make a part possible. Of the family that is nearest to one, where no family has one.
    struct Lever {
        std::string what;  ///< "torque" [Nm, the largest], "range" [rad, the last angle], "bed" [m]
        double value = 0.0, was = 0.0;
    };
    std::vector<Lever> levers = {};
    double missing = 0.0;     ///< without a part: a measure of how far the nearest candidate is from one
    std::string bought = {};  ///< name of its spring in the catalogue; "": a spring that can be wound
    [[nodiscard]] bool found() const { return profile.has_value(); }
};

struct Options {
    std::vector<std::string> families = {"spool", "cable", "helix", "two_cables", "roller", "arm"};  ///< two_cables: of a law of both signs
    int generations = 40;                                                                            ///< of the search of each family
    spring::Catalogue catalogue = {};  ///< springs on sale, of which each part takes one; empty: springs are wound
    bool front = false;                ///< find Family::front
    bool repair = false;               ///< where no part of any family is found, the law may be changed
    bool files = true;                 ///< every file of a part found is made and read back
    unsigned jobs = 0;                 ///< threads; 0: one per processor; no influence on the result
    /// Called with a label before each family, and before the search of levers; may be empty.
    std::function<void(const std::string& step)> progress = {};
    std::function<bool()> stop = {};  ///< asked between generations; may be empty
};

/// Searches, in each family, base spring, preload, size and thickness for the least room of part and spring without a broken rule, by
/// differential evolution over `pipeline::evaluate`; winds the spring, or takes that of the catalogue whose rate is next, and judges the
/// solid. Law, process, material, cable, hub, roller and the rest of the profile stay. The name of a profile found is that of the profile,
/// "-" and that of its family.
/// With `repair`, where no family has a part, the law is smoothed and scaled as little as possible with it, then brought to the nearest
/// one, by the root mean square over the angle, for which that part with its spring breaks no rule. Such a law is one of points.
/// @pre profile.is_spring() @throws core::InvalidInput naming the key; core::Stopped when `stop` says so
[[nodiscard]] std::vector<Family> find_smallest(const profile::Profile& profile, const Options& options);

/// The family of the least room, part's cylinder and spring, of changed laws the one changed least; nullptr if none was found.
[[nodiscard]] const Family* smallest(const std::vector<Family>& families);

}  // namespace fusee::search::one_spring
