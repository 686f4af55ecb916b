#pragma once
#include <string>
#include <vector>

#include "fusee/simulator/case.h"

namespace fusee::simulator {

/// fusee's companion for MuJoCo: beside the program, else on PATH.
/// @param place of the key in messages @throws core::InvalidInput if there is none, with what to install
[[nodiscard]] std::string mujoco_companion(const std::string& place);

/// Asks a process what it can do: {"id": 0, "describe": true}. Fills in parameters and effects.
/// @pre model, command and timeout are there @param place of the key in messages
/// @throws core::InvalidInput with the words of the process
void ask_description(const std::string& place, Case& to);

}  // namespace fusee::simulator
