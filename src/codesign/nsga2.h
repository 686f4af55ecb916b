#pragma once
#include "front.h"

/// The one function of the module fusee_nsga2.so, which find_front loads. Searches numbers that all have a range, with the threads of the
/// caller. @param front set to the result
extern "C" [[gnu::visibility("default")]] void fusee_nsga2(const fusee::codesign::Costs& costs,
                                                           const fusee::codesign::FrontOptions& options, fusee::codesign::Front& front);
