#pragma once
#include <string_view>

namespace fusee::search::init {

/// profiles/pnrvsa.toml at the time of the build: the design that is scaled.
extern const std::string_view kStart;

}  // namespace fusee::search::init
