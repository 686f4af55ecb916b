#pragma once
#include <string_view>

namespace fusee::exchange {

/// The files of the folder templates/ at the time of the build.
extern const std::string_view kSeriesTemplate, kParallelTemplate, kLibraryTemplate;

}  // namespace fusee::exchange
