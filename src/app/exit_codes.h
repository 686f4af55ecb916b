#pragma once

namespace fusee::app {

/// Exit codes of every command; 0 is success (docs/commands.md).
inline constexpr int kRefused = 1, kBadInput = 2, kFailed = 3, kInterrupted = 130;

}  // namespace fusee::app
