#pragma once
#include <vector>

#include "scan.h"

namespace fusee::search::fix {

/// A possible change against a finding. The search judges whether it helps.
struct Move {
    core::Changes changes;
    Follows follows;
    core::Finding because;
    int left = 0;  ///< findings expected afterwards: of a suggestion at best, of a scan as judged
};

/// The changes that the finding suggests, in its order, except changes of facts, of sizes that are not on sale and of parts that are not
/// known to be strong enough. A base spring that was already changed for its cam is not changed for it again.
/// @param finding of `verdict` @param draft the profile with `choices` @param refused by key: why its change was refused; the first
/// reason stays
[[nodiscard]] std::vector<Move> suggested(const core::Finding& finding, const Verdict& verdict, const profile::Profile& draft,
                                          const Choices& choices, const Drafts& drafts, std::map<std::string, std::string>& refused);

/// Base springs and laws that a scan finds, if law and cams do not fit each other.
[[nodiscard]] std::vector<Move> scanned(const Verdict& verdict, const profile::Profile& draft, const Choices& choices, Scan& scan);

}  // namespace fusee::search::fix
