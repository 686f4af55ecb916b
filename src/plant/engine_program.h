#pragma once
#include <functional>
#include <memory>

#include "fusee/plant/machine.h"

namespace fusee::plant {

/// Of one rig at random; the random numbers are a stream that no case and no label is drawn from.
using DrawEngine = std::function<std::unique_ptr<Engine>(Random& random)>;

/// What a program of an engine does: for each line {"seed": 1, "index": 0, "folder": "case000", "effects": [...]} of its input it writes a
/// gap case whose rig this engine moves, and answers "written". fusee blind make asks it: on a command line any user would see the sealed
/// effects.
/// @param name of the engine as --plant has it
/// @return the exit code
int write_cases(int count, char** words, const char* name, const DrawEngine& draw);

}  // namespace fusee::plant
