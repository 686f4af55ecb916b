#pragma once
#include <string_view>

namespace fusee::search::fix {

/// The meaning of a change of a key for the builder of the joint.
struct Policy {
    std::string_view key;  ///< without its part ("k_se.", "k_pe.", "cam."); ends in '.' for a whole table
    double weight;         ///< a change costs this and ln of its factor
    const char* asks_for;
    bool graded = false;  ///< its suggestions come in coarse steps: the nearest value is searched
};

/// nullptr for facts: what the rig is, what a machine can do, what a material bears.
[[nodiscard]] const Policy* policy_of(std::string_view key);

}  // namespace fusee::search::fix
