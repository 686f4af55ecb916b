#pragma once
#include "fusee/diagnosis/diagnosis.h"

namespace fusee::diagnosis {

/// What a verdict rests on: how the best hypothesis stands.
struct Grounds {
    bool explains = true;   ///< it leaves no gap that a correct model does not leave
    bool rivalled = false;  ///< another one is too likely (inference::rivalled)
    bool named = false;     ///< it holds effects
    bool doubted = false;   ///< what these rows cannot show, or a figure that nobody stated, forbids a certain answer
};
/// The one rule of every verdict.
[[nodiscard]] VerdictKind verdict_of(const Grounds& grounds);

}  // namespace fusee::diagnosis
