#pragma once
#include <string_view>

namespace fusee::init {

/// profiles/pnrvsa.toml at the time of the build: the design that is scaled.
extern const std::string_view kStart;

}  // namespace fusee::init
