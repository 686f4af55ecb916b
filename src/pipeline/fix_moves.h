#pragma once
#include <vector>

#include "fix_scan.h"

namespace fusee::pipeline {

/// Something that could be done about a finding. Whether it helps is for the search to judge.
struct Move {
    core::Changes changes;
    core::Finding because;
    int left = 0;  ///< objections to be expected afterwards: of a suggestion at best, of a scan as it was judged
};

/// What the finding's suggestion names, in its order, as far as it changes no fact. A base spring that has been changed because its cam
/// could not be had is not changed for that again: what one left standing, the next is not going to take away.
/// @param finding of `verdict` @param draft the profile with `choices`
[[nodiscard]] std::vector<Move> suggested(const core::Finding& finding, const Verdict& verdict, const profile::Profile& draft,
                                          const Choices& choices);

/// Where law and cams do not suit each other, the base springs and laws that a scan finds.
[[nodiscard]] std::vector<Move> scanned(const Verdict& verdict, const profile::Profile& draft, const Choices& choices, Scan& scan);

}  // namespace fusee::pipeline
