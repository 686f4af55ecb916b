#pragma once
#include <string>

#include "fusee/identification/break_away.h"

namespace fusee::identification {

/// A gear's friction as identified from one file of break-away tests.
struct Identification {
    std::string name;         ///< of the file, without its ending
    std::string file_sha256;  ///< of the CSV as read
    FrictionReport friction;
};

}  // namespace fusee::identification
