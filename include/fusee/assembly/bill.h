#pragma once
#include <string>
#include <vector>

#include "fusee/assembly/assembly.h"

namespace fusee::assembly {

/// One line of the bill of materials: all equal pieces of both sides.
struct BillRow {
    std::string item;  ///< "k_se", "torsion spring", "series cable"
    int count = 1;
    std::string size;  ///< with units; a catalogue's designation where there is one
    std::string note;  ///< file, place or what is not stated
};

/// What the joint consists of, both sides: parts, springs, cables cut to length, shafts, keys, bearings, bushes. The frame and the motors
/// are not in it.
[[nodiscard]] std::vector<BillRow> bill_of(const Assembly& assembly);

}  // namespace fusee::assembly
