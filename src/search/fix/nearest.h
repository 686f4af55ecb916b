#pragma once
#include <map>
#include <string>

#include "draft.h"
#include "judge.h"

namespace fusee::search::fix {

/// A profile that can be made, as near to the original as its choices allow.
struct Nearest {
    Choices choices;
    std::map<std::string, core::Finding> binds;  ///< by key of the law: the finding against a nearer value
};

/// Undoes each choice that is not needed with the others, then moves law and base springs back by halves while every limit holds; the
/// changes of one suggestion move together. @pre `found` is made with every file, and judged last by `judge`
[[nodiscard]] Nearest undo_needless(const Drafts& drafts, Judge& judge, Choices found);

}  // namespace fusee::search::fix
