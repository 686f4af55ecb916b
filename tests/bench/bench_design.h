#pragma once
// The design that the benchmarks of stages and of other programs share: K_SE (0) or K_PE (1) of profiles/pnrvsa.toml.
#include <filesystem>

#include "fusee/pipeline/design.h"
#include "fusee/profile/profile.h"

namespace fusee::bench {

inline const pipeline::ResolvedDesign& design() {
    static const pipeline::ResolvedDesign resolved =
        pipeline::resolve(profile::read_profile(std::filesystem::path(FUSEE_SOURCE_DIR) / "profiles" / "pnrvsa.toml")).value();
    return resolved;
}

inline cam::PartKind kind(std::int64_t number) { return number == 0 ? cam::PartKind::kSeries : cam::PartKind::kParallel; }

inline const cam::Cam& cam(std::int64_t number) {
    static const cam::Cam series = pipeline::design_cam(cam::PartKind::kSeries, design()).value();
    static const cam::Cam parallel = pipeline::design_cam(cam::PartKind::kParallel, design()).value();
    return number == 0 ? series : parallel;
}

inline const solid::Part& part(std::int64_t number) {
    static const solid::Part series = pipeline::design_part(kind(0), design()).value().part;
    static const solid::Part parallel = pipeline::design_part(kind(1), design()).value().part;
    return number == 0 ? series : parallel;
}

}  // namespace fusee::bench
