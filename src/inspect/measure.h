#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/checks/judge.h"
#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "fusee/inspect/rule.h"
#include "vector.h"

namespace fusee::inspect {

using checks::Allowed, checks::is_milled, checks::is_printed, checks::is_stacked, checks::compare, checks::kAtLeast, checks::kAtMost,
    checks::of_process, checks::required, checks::review, checks::up, checks::down;

/// Sets the finding's place and its text: "at (1.20, 0.00, 3.50) mm".
void set_place(core::Finding& finding, const Vec3& at_mm);
/// Name of a body in a text.
std::string named(const File& file, std::size_t piece);
Vec3 middle_of(const Body& body, std::uint32_t triangle);
/// The triangles of the samples that `wanted` selects, ascending and once each.
std::vector<std::uint32_t> triangles_of(const Body& body, const std::function<bool(const Sample&)>& wanted);

}  // namespace fusee::inspect
