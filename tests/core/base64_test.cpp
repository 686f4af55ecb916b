#include <gtest/gtest.h>

#include "fusee/core/text.h"

namespace fusee::core {
namespace {

// RFC 4648, section 10.
TEST(Base64, HasTheKnownAnswers) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(from_base64("Zm9v\nYmE="), "fooba");
}

}  // namespace
}  // namespace fusee::core
