#include "fusee/report/picture.h"

#include <gtest/gtest.h>

#include "fixture.h"
#include "fusee/core/error.h"
#include "picture/plot.h"
#include "picture/standalone.h"

namespace fusee::report {
namespace {

std::vector<Figure> two_charts() {
    Plot one("One & two", "x [m]", "y [m]");
    one.curve("first", {0.0, 1.0}, {0.0, 2.0}, "se").curve("second", {0.0, 1.0}, {1.0, 1.0}, "pe", true);
    Plot other("Other", "x [m]", "y [m]");
    other.curve("first", {0.0, 1.0}, {0.0, 2.0}, "t");
    return {one.figure(), other.figure()};
}

// Other programs read the file: no variable of a style sheet is left, and every class of a curve has its rule.
TEST(Picture, StandsAlone) {
    for (const Theme theme : {Theme::kLight, Theme::kDark}) {
        const std::string svg = standalone(two_charts(), theme);
        EXPECT_EQ(svg.find("var("), std::string::npos);
        EXPECT_EQ(svg.find("currentColor"), std::string::npos);
        for (const char* rule : {".curve{", ".curve.se{stroke:", ".curve.pe{stroke:", ".dashed{", ".plot .name{fill:", "svg text{fill:"})
            EXPECT_NE(svg.find(rule), std::string::npos) << rule;
        EXPECT_NE(svg.find("One &amp; two"), std::string::npos);
        EXPECT_NE(svg.find("Other"), std::string::npos);
    }
    const auto card = [](Theme theme) {
        const std::string svg = standalone({}, theme);
        return svg.substr(svg.find("<rect"));
    };
    EXPECT_NE(card(Theme::kLight).find("#fff"), std::string::npos);
    EXPECT_NE(card(Theme::kDark).find("#1c1c1f"), std::string::npos);
}

TEST(Picture, RefusesWhatADesignDoesNotHave) {
    const DesignReport none;
    for (const PictureView& view : design_views()) {
        if (view.name == "cams") continue;  // of no parts: nothing to see, and nothing wrong
        EXPECT_THROW(static_cast<void>(design_picture(none, view.name)), core::InvalidInput) << view.name;
    }
    EXPECT_THROW(static_cast<void>(motion_picture(none, 100)), core::InvalidInput);
    try {
        static_cast<void>(design_picture(none, "deadband"));
        FAIL();
    } catch (const core::InvalidInput& e) {
        EXPECT_EQ(e.field(), "--view");
        EXPECT_NE(e.allowed().find("dead-band"), std::string::npos);
    }
}

}  // namespace
}  // namespace fusee::report
