#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "fusee/plant/rig.h"

namespace fusee::plant {

/// Something that the nominal model does not have. Ids of the case format, or "outside.NAME" for what is in no table.
struct Effect {
    std::string id;
    std::string side = "none";                                      ///< agonist, antagonist or both; none for what has no side
    double size = 0.0;                                              ///< in the unit that the format gives for the id
    std::vector<std::pair<std::string, double>> extra;              ///< further parameters of its law, by name
    [[nodiscard]] double parameter(const std::string& name) const;  ///< @pre it has one
};

/// Known to the format's table, and none of its ids; each in one order.
[[nodiscard]] const std::vector<std::string>& library_ids();
[[nodiscard]] const std::vector<std::string>& outside_ids();

/// Side and size at random, well above tolerance and noise on this rig.
/// @throws core::InvalidInput "effect" if neither list has the id
[[nodiscard]] Effect draw_effect(const std::string& id, const Nominal& nominal, Random& random);
/// Builds it into the rig. @throws core::InvalidInput "effect" or "effect.side"
void apply(const Effect& effect, Truth& truth);

}  // namespace fusee::plant
