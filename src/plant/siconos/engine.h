#pragma once
#include "fusee/plant/machine.h"

namespace fusee::plant {

/// Siconos moves the rig: Moreau-Jean time stepping, set-valued Coulomb friction without any creep, stops without rebound. Springs, the
/// limit of a friction and the faults are those of Truth; a gear at rest breaks away at this limit, as Engine says.
/// @throws core::InputError in Siconos' words
class SiconosEngine final : public Engine {
public:
    [[nodiscard]] std::unique_ptr<Motion> start(const Truth& truth, const BuiltSprings& springs, double session) const override;
};

}  // namespace fusee::plant
