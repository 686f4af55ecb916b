#pragma once
#include <mutex>

namespace fusee::exchange {

/// OpenCASCADE's STEP keeps its settings in globals: one reader or writer at a time. The first call readies it and silences what it would
/// print.
[[nodiscard]] std::mutex& step_session();

}  // namespace fusee::exchange
