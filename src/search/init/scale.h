#pragma once
#include <string>

#include "fusee/core/units.h"
#include "fusee/profile/profile.h"
#include "fusee/search/init.h"

namespace fusee::search::init {

/// The numbers that the search changes, relative to the start design (docs/guides/init.md).
struct Scale {
    double k_pe = 1.0;      ///< lengths of K_PE's cam
    double k_se = 1.0;      ///< lengths of K_SE's spool
    double capstan = 1.0;   ///< capstan's radius over the spool's lengths
    double softness = 1.0;  ///< capstan angles: 1/k
    double preload_pe = 1.0, preload_se = 1.0;
    double transmission = 0.44;  ///< T at the law's start
    double u_share = 0.0;        ///< share of u in it
    double start = 0.9;          ///< of the least load that stiction allows; of a measured law: that it is asked
    double end = 1.06;           ///< of the greatest
    core::Range asked = {};      ///< of a measured law: loads at the dead-band's edges, within `carried` [Nm]
    core::Range carried = {};    ///< of a measured law: loads that it has [Nm]
};

/// Lengths of the start design that the cable's least bend and the shaft ask for.
struct Sizes {
    double k_pe = 1.0, k_se = 1.0;
};
[[nodiscard]] Sizes least_sizes(const Answers& answers);

/// Scaling laws of a pair of cams: with energies times E, capstan angles times a, arms times L, a torsion spring's angle scales with g =
/// a r_c/L and its rate with E/g^2; a compression spring's travel with a L, its rate with E/(a L)^2. Neither arm nor law changes its shape.
/// @returns the start design with rig, law, cable, process, hubs and base springs of the answers; the springs have no wire yet
[[nodiscard]] profile::Profile scaled(const std::string& name, const Answers& answers, const Scale& scale);

/// Stiffness of the joint at the torque, capstans held, of the start design's law for these answers but no stiffness [Nm/rad].
/// @pre no measured law
[[nodiscard]] double chosen_stiffness(const Answers& answers);

/// Cable, process, hubs, grooves and anchors of both parts as the answers say.
void set_parts(profile::Profile& p, const Answers& answers, const Scale& scale);

/// What the answers say of the columns of the one file and not of the other.
[[nodiscard]] core::CsvMapping columns_of_law(core::CsvMapping columns);
[[nodiscard]] core::CsvMapping columns_of_friction(core::CsvMapping columns);

}  // namespace fusee::search::init
