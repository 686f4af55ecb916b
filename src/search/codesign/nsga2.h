#pragma once
#include "front.h"

/// The one function of the module fusee_nsga2.so, which find_front loads. Searches numbers that all have a range, with the threads of the
/// caller. @param front set to the result
extern "C" [[gnu::visibility("default")]] void fusee_nsga2(const fusee::search::codesign::Costs& costs,
                                                           const fusee::search::codesign::FrontOptions& options,
                                                           fusee::search::codesign::Front& front);
