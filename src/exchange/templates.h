#pragma once
#include <string_view>

namespace fusee::exchange {

/// The files of the folder templates/, as they were when the program was built.
extern const std::string_view kSeriesTemplate, kParallelTemplate, kLibraryTemplate;

}  // namespace fusee::exchange
