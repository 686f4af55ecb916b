#pragma once
#include <string>

namespace fusee::app {

/// "a1b2c3d4e5f6, Release, GNU 12.2.0": commit, kind of build, compiler. The same for the same sources and options, in any folder.
[[nodiscard]] std::string build_name();

}  // namespace fusee::app
