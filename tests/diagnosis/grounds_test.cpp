#include "fusee/diagnosis/grounds.h"

#include <gtest/gtest.h>

namespace fusee::diagnosis {
namespace {

TEST(Grounds, DecidesTheVerdict) {
    EXPECT_EQ(verdict_of({.named = true}), VerdictKind::kIdentified);
    EXPECT_EQ(verdict_of({.named = false}), VerdictKind::kNone);
    for (const bool named : {false, true})
        for (const bool doubted : {false, true}) {
            EXPECT_EQ(verdict_of({.rivalled = true, .named = named, .doubted = doubted}), VerdictKind::kAmbiguous);
            EXPECT_EQ(verdict_of({.explains = false, .rivalled = true, .named = named, .doubted = doubted}), VerdictKind::kUnknown);
        }
}

TEST(Grounds, ADoubtForbidsACertainAnswer) {
    EXPECT_EQ(verdict_of({.named = true, .doubted = true}), VerdictKind::kAmbiguous);
    EXPECT_EQ(verdict_of({.named = false, .doubted = true}), VerdictKind::kInconclusive);
}

}  // namespace
}  // namespace fusee::diagnosis
