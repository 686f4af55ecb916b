#pragma once
#include <map>
#include <string>

#include "draft.h"
#include "judge.h"

namespace fusee::fix {

/// A profile that can be made, as near to the original as its choices allow.
struct Nearest {
    Choices choices;
    std::map<std::string, core::Finding> binds;  ///< by key of the law: what stands against a value that is nearer
};

/// Undoes each choice that the others make needless, then halves the way back of law and base springs while every limit holds: what a
/// suggestion joins moves together. @pre `found` is made with every file, and judged last by `judge`
[[nodiscard]] Nearest undo_needless(const Drafts& drafts, Judge& judge, Choices found);

}  // namespace fusee::fix
