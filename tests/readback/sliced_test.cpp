#include <fmt/format.h>

#include "exchange/fixtures/disc.h"
#include "exchange/fixtures/expect_refusal.h"
#include "fusee/core/file.h"
#include "fusee/formats/format.h"

namespace fusee::readback {
namespace {

using exchange::PartFile;
using exchange::PartGuide;

constexpr int kCorners = 2000;         // an inscribed polygon is short of its circle by R (pi / 2000)^2 / 2: 1.2e-6 of the radius
constexpr double kDigits_mm = 7.1e-4;  // three decimals, as PrusaSlicer's: half a unit of the last one in X and in Y

/// One layer of a print: its outer bead's centreline is a circle about (5, 0).
struct Layer {
    double top_mm, height_mm, radius_mm;
};

/// G-code in PrusaSlicer's dialect. Infill and inner perimeters, which lie outside of the circle here, are not to be read.
std::string gcode(const std::vector<Layer>& layers, double lowest_mm, double width_mm, bool relative = true) {
    std::string text = fmt::format("; fusee test\n; sliced by hand\n; fusee: z of the part = Z + {} mm\nG21 ; mm\nG90\n{}\n", lowest_mm,
                                   relative ? "M83" : "M82");
    for (const Layer& layer : layers) {
        text += fmt::format(
            ";LAYER_CHANGE\n;Z:{}\n;HEIGHT:{}\nG1 Z{} F7800\nG92 E0\n;TYPE:Perimeter\n;WIDTH:0.5\nG1 X60 Y0 F7800\nG1 X60 Y9 E.1\n",
            layer.top_mm, layer.height_mm, layer.top_mm);
        text += fmt::format(";TYPE:External perimeter\n;WIDTH:{}\nG1 F1800\n", width_mm);
        double filament = 0.1;
        for (int i = 0; i <= kCorners; ++i) {
            const double psi = 2.0 * core::kPi * i / kCorners;
            text += fmt::format("G1 X{:.3f} Y{:.3f}", 5.0 + layer.radius_mm * std::cos(psi), layer.radius_mm * std::sin(psi));
            text += i == 0 ? " F7800\n" : fmt::format(" E{:.5f}\n", relative ? 0.001 : filament += 0.001);
        }
        text += "G1 X0 Y70 E-2 ; a retraction on the way\n;TYPE:Internal infill\n;WIDTH:0.5\nG1 X70 Y70 E5\n";
    }
    return text;
}

class SlicedTest : public fixtures::FolderTest {
protected:
    /// The disc of the fixture: pitch radius 20 mm, cable 1 mm, so the floor's radius is 19.5 mm.
    [[nodiscard]] ArmError read(const std::string& text, PartFile part) const {
        core::write_file(folder_ / "a.gcode", text);
        part.files = {{"a.gcode", core::sha256_hex(text), 0, 0.2}};
        const std::vector<ArmError> errors = formats::read_back(folder_, part);
        EXPECT_EQ(errors.size(), 1u);
        return errors.front();
    }
    [[nodiscard]] static PartFile disc() { return fixtures::disc_part({}, {"parallel", {std::cos(0.7), std::sin(0.7)}, {}, 0.0, 1}, 1, 1); }
    static void expect_arms(const ArmError& error, const PartFile& part, double longer_mm) {
        ASSERT_EQ(error.arms_mm.size(), part.target.size());
        for (std::size_t i = 0; i < part.target.size(); ++i)
            EXPECT_NEAR(error.arms_mm[i], part.target[i].arm_mm + longer_mm, kDigits_mm + 20.0 * 1.2e-6) << i;
    }
};

// Known: a layer whose middle lies in the cable's plane has its outline half a bead outside of the nozzle's path.
TEST_F(SlicedTest, OutlineIsHalfABeadOutsideOfTheCentreline) {
    const PartFile part = disc();
    for (const bool relative : {true, false}) {
        const ArmError error = read(gcode({{10.1, 0.2, 19.5 - 0.225}}, -10.0, 0.45, relative), part);
        EXPECT_EQ(error.reader, "perimeters");
        EXPECT_EQ(error.when_broken, core::Severity::kWarning);
        expect_arms(error, part, 0.0);
        EXPECT_LT(error.worst_relative, (kDigits_mm + 2.4e-5) / 15.0);
    }
}

// Known: a cable of radius 0.5 between two layers rests on both noses, circles of radius 0.1 whose middles are 0.1 off its plane.
TEST_F(SlicedTest, CableRestsOnTheNosesOfTheBeadsBesideIt) {
    const PartFile part = disc();
    const double r = 19.5 - 0.225;
    const double longer = std::sqrt(0.6 * 0.6 - 0.1 * 0.1) - 0.6;
    expect_arms(read(gcode({{10.0, 0.2, r}, {10.2, 0.2, r}}, -10.0, 0.45), part), part, longer);
    // A neighbour that stands out by 0.1 mm carries it: centres 0.6 apart, 0.2 off.
    const double carried = 0.1 + std::sqrt(0.6 * 0.6 - 0.2 * 0.2) - 0.6;
    expect_arms(read(gcode({{10.1, 0.2, r}, {10.3, 0.2, r + 0.1}}, -10.0, 0.45), part), part, carried);
    // One 0.61 mm above passes the cable by, however far it stands out.
    expect_arms(read(gcode({{10.1, 0.2, r}, {10.71, 0.2, r + 3.0}}, -10.0, 0.45), part), part, 0.0);
}

TEST_F(SlicedTest, MoreThanHalfALayerOffIsForReview) {
    const PartFile part = disc();
    double least = 1e9;
    for (const exchange::TargetRow& row : part.target) least = std::min(least, row.arm_mm);
    const ArmError good = read(gcode({{10.1, 0.2, 19.5 - 0.225 + 0.09}}, -10.0, 0.45), part);
    EXPECT_NEAR(good.allowed, 0.1 / least, 1e-12);
    EXPECT_TRUE(good.passed());
    EXPECT_FALSE(read(gcode({{10.1, 0.2, 19.5 - 0.225 + 0.12}}, -10.0, 0.45), part).passed());
    EXPECT_FALSE(read(gcode({{10.1, 0.2, 19.5 - 0.225}}, -8.0, 0.45), part).passed()) << "no bead at the cable's height: no arm";
}

// A groove that rises 3 mm per turn: h = R + g psi, so its points are (h c - g s, h s + g c) at z = 3 psi/(2 pi). Every layer is a bead
// along the whole groove, at the height where it stands; layers of 0.05 mm leave the cable's height at most half a layer off: 0.025^2/1.05
// = 0.6 um.
TEST_F(SlicedTest, HelixMeetsItsOwnTurnOnly) {
    const double radius = 8.0, growth = 0.4, travel = 9.0, layer = 0.05, width = 0.45;
    PartFile part = fixtures::disc_part({}, {"parallel", {0.0, 1.0}, {}, 0.0, 1}, 1, -1, travel);
    for (exchange::TargetRow& row : part.target) {
        const double psi = row.angle_rad, h = radius + growth * psi, c = std::cos(psi), s = std::sin(psi);
        row.arm_mm = h;
        row.contact_mm = {h * c - growth * s, h * s + growth * c, 3.0 * psi / (2.0 * core::kPi)};
    }
    std::string text = "; fusee: z of the part = Z + -2 mm\nM83\n";
    for (int k = 0; k < 170; ++k) {
        const double top = (k + 1) * layer;
        text += fmt::format(";Z:{:.2f}\n;HEIGHT:{}\n;TYPE:External perimeter\n;WIDTH:{}\n", top, layer, width);
        for (int i = 0; i <= 40; ++i) {  // the piece of groove that lies in this layer, and a little more
            const double z = top - layer / 2.0 - 2.0 + (i / 40.0 - 0.5) * 1.1 * layer, psi = z * 2.0 * core::kPi / 3.0;
            const double h = radius + growth * psi - 0.5 - width / 2.0, c = std::cos(psi), s = std::sin(psi);
            text += fmt::format("G1 X{:.4f} Y{:.4f}{}\n", h * c - growth * s, h * s + growth * c, i == 0 ? "" : " E.01");
        }
    }
    const ArmError error = read(text, part);
    for (std::size_t i = 0; i < part.target.size(); ++i) EXPECT_NEAR(error.arms_mm[i], part.target[i].arm_mm, 2e-3) << i;
}

TEST_F(SlicedTest, RefusesWhatItDoesNotUnderstand) {
    const std::string good = gcode({{10.1, 0.2, 19.275}}, -10.0, 0.45);
    const auto refused = [&](const std::string& from, const std::string& to, std::initializer_list<std::string> words) {
        std::string text = good;
        ASSERT_NE(text.find(from), std::string::npos) << from;
        text.replace(text.find(from), from.size(), to);
        fixtures::expect_refusal([&] { (void)read(text, disc()); }, words);
    };
    refused("; fusee: z", "; z", {"a.gcode", "the part's height"});
    refused(";TYPE:External perimeter", ";TYPE:Perimeter", {"a.gcode", "no external perimeter"});
    refused("G90", "G91", {"a.gcode:5", "G91 is not understood"});
    refused("G21", "G20", {"a.gcode:4", "G20 is not understood"});
    refused("G1 F1800", "G2 X1 Y1 I2 J2 E1", {"a.gcode", "G2 is not understood"});
    refused("E.1", "Ex", {"a.gcode:15", "is no number"});
    refused(";WIDTH:0.45", ";WIDTH:0.1", {"a.gcode", "width"});
}

}  // namespace
}  // namespace fusee::readback
