#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fusee/cam/cam.h"
#include "fusee/design/budget.h"
#include "fusee/pipeline/design.h"

namespace fusee::pipeline {

/// The budget's input: contours by the process, the rest by the profile's table [budget].
/// @param cams K_SE's, K_PE's; they must outlive the result @returns none for a cam with a roller: it is not modelled
[[nodiscard]] std::optional<design::budget::Subject> budget_subject(const ResolvedDesign& design,
                                                                    const std::array<const cam::Cam*, 2>& cams);

/// The budget of a single spring. @param cams its own, or those of both its cables, as parts_of
[[nodiscard]] design::budget::Budget spring_budget(const ResolvedDesign& design, std::span<const cam::Cam* const> cams);

/// The budget of a profile: of its joint at its three torques, or of its single spring. Refusal: that of its law or of a cam.
/// @param draws joints to sample; a single spring is computed to first order @throws core::InvalidInput naming the key, also for a joint
/// with a roller
[[nodiscard]] core::Outcome<design::budget::Budget> find_budget(const profile::Profile& profile, int draws);

/// The same tolerances for `design::robust_dead_band`, which needs no cam: no runout, guide, preload, cable and zero.
[[nodiscard]] design::ShopScatter shop_scatter(const profile::Profile& profile);

/// Names of the processes whose contours are at least so accurate [m], the coarsest first.
[[nodiscard]] std::vector<std::string> processes_within(double tolerance);

}  // namespace fusee::pipeline
