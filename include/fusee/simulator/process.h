#pragma once

#include "fusee/simulator/model.h"

namespace fusee::simulator {

/// Processes of the case's command, each asked one question at a time, a line of JSON for a line of JSON
/// (docs/guides/my-simulator-does-not-match.md). They end with the last copy of the result.
/// Its calls throw core::InvalidInput naming [model] with the question in a file to repeat, if a process ends, is too slow or answers
/// with anything but such a line; core::Stopped if core::interrupted().
/// @param jobs processes at most, 0: one per processor @throws core::IoError if the command cannot be started
[[nodiscard]] Simulate start_processes(const Case& of_case, unsigned jobs);

}  // namespace fusee::simulator
