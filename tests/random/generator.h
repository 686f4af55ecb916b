#pragma once
#include <cstdint>
#include <string>

namespace fusee::random_profiles {

/// A design as somebody might ask for it: rig, kind of law, cable, both base springs, guides, paths, hubs and process are drawn; the base
/// springs are chosen so that the arms are of a size that a cam can have. Nothing is tried out: whether it can be made is fusee's to say.
/// The same seed and number give the same text on every machine.
/// @param number goes into the name, so that each design has a folder of its own
[[nodiscard]] std::string random_profile(std::uint64_t seed, int number);

/// A design near one that somebody built: a shipped profile (pnrvsa, pnrvsa_co_design, free_curve or from_dead_band) in which some figures are
/// a few percent off, with another cable, bore, process or guide now and then. Written as STL, 3MF and DXF. The same text on every machine.
[[nodiscard]] std::string near_profile(std::uint64_t seed, int number);

}  // namespace fusee::random_profiles
