#pragma once
#include <string>

namespace fusee::drawing {

/// Fields of a title block (ISO 7200) that only the owner of a drawing knows; empty: not stated.
struct TitleOptions {
    std::string owner;        ///< legal owner
    std::string number;       ///< identification number of the design; a part's has its name behind it
    std::string revision;     ///< index
    std::string date;         ///< of issue
    std::string created_by;   ///< creator
    std::string approved_by;  ///< approval person
};

}  // namespace fusee::drawing
