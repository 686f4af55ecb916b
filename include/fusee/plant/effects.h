#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "fusee/plant/rig.h"

namespace fusee::plant {

/// An effect that the nominal model does not have. Ids of the case format, or "outside.NAME".
struct Effect {
    std::string id;
    std::string side = "none";                                      ///< agonist, antagonist or both; none for effects without sides
    double size = 0.0;                                              ///< in the unit that the format gives for the id
    std::vector<std::pair<std::string, double>> extra;              ///< further parameters of its law, by name
    [[nodiscard]] double parameter(const std::string& name) const;  ///< @pre it has one
};

/// Ids of the format, and ids outside of it, in fixed order.
[[nodiscard]] const std::vector<std::string>& library_ids();
[[nodiscard]] const std::vector<std::string>& outside_ids();

/// Side and size at random, well above tolerance and noise on this rig.
/// @throws core::InvalidInput "effect" if neither list has the id
[[nodiscard]] Effect draw_effect(const std::string& id, const Nominal& nominal, Random& random);
/// Applies it to the rig. @throws core::InvalidInput "effect" or "effect.side"
void apply(const Effect& effect, Truth& truth);

}  // namespace fusee::plant
