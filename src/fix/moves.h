#pragma once
#include <vector>

#include "scan.h"

namespace fusee::fix {

/// Something that could be done about a finding. Whether it helps is for the search to judge.
struct Move {
    core::Changes changes;
    Follows follows;
    core::Finding because;
    int left = 0;  ///< objections to be expected afterwards: of a suggestion at best, of a scan as it was judged
};

/// What the finding's suggestion names, in its order, as far as it changes no fact. A base spring that has been changed because its cam
/// could not be had is not changed for that again: what one left standing, the next is not going to take away.
/// What is not on sale, or not known to be strong enough, is no move.
/// @param finding of `verdict` @param draft the profile with `choices` @param refused by key: why a change of it was no move; the first
/// reason stays
[[nodiscard]] std::vector<Move> suggested(const core::Finding& finding, const Verdict& verdict, const profile::Profile& draft,
                                          const Choices& choices, const Drafts& drafts, std::map<std::string, std::string>& refused);

/// Where law and cams do not suit each other, the base springs and laws that a scan finds.
[[nodiscard]] std::vector<Move> scanned(const Verdict& verdict, const profile::Profile& draft, const Choices& choices, Scan& scan);

}  // namespace fusee::fix
