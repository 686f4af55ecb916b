#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "fusee/pipeline/design.h"
#include "fusee/profile/edit.h"
#include "fusee/spring/catalogue.h"

/// The way from the base springs that a profile wants to springs that can be wound or bought (docs/guides/find-springs.md).
namespace fusee::pipeline {

/// A spring that passes every rule about springs on the profile's cam.
struct FoundSpring {
    std::string name;           ///< "1.1 x 10.8 x 24", or that of the catalogue
    spring::BaseSpring spring;  ///< with its own rate, and the preload that keeps the load at the law's beginning
    double volume = 0.0;        ///< that its body fills [m^3]
    bool bought = false;        ///< from the catalogue
};

struct SpringSearchOptions {
    spring::WireClass wire_class = spring::WireClass::kSh;  ///< of wound springs, where the profile states none
    double cycles = 1e5;                                    ///< where the profile states none
    double within = 0.02;                                   ///< largest difference of a wound spring's rate, relative
    std::size_t most = 5;                                   ///< springs to return of each kind
    bool accept_reviews = false;                            ///< springs with warnings too
    bool with_cam = true;                                   ///< only those for which the contour passes; false: the caller looks
};

/// The springs for one part.
struct SpringSearch {
    cam::PartKind part = cam::PartKind::kSeries;
    std::string table;                                        ///< of the part in the profile: "k_se"
    spring::BaseSpring wanted;                                ///< the profile's
    core::Range loads;                                        ///< of the working range [Nm or N]
    std::vector<FoundSpring> wound, bought;                   ///< the smallest first; of the catalogue the nearest rate first
    std::size_t tried = 0;                                    ///< springs judged
    std::vector<std::pair<std::string, std::size_t>> broken;  ///< rules that tried springs broke, the most frequent first
};

/// Searches standard wires and coils, and the catalogue. Refusal: that of the cam of the profile's own spring.
/// @throws core::InvalidInput naming the key
[[nodiscard]] core::Outcome<SpringSearch> find_springs(cam::PartKind part, const ResolvedDesign& design, const spring::Catalogue& catalogue,
                                                       const SpringSearchOptions& options = {});

/// The keys that put a spring in the place of the profile's.
[[nodiscard]] std::vector<profile::Edit> spring_edits(cam::PartKind part, const FoundSpring& found, const profile::Profile& profile);

}  // namespace fusee::pipeline
