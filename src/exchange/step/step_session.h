#pragma once
#include <mutex>

namespace fusee::exchange {

/// STEP in OpenCASCADE has global settings: one reader or writer at a time. The first call initializes it and turns its messages off.
[[nodiscard]] std::mutex& step_session();

}  // namespace fusee::exchange
