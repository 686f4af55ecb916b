#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "fusee/coupon/calibration.h"
#include "refused.h"

namespace fusee::coupon {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Errors of a part that was made.
struct Made {
    double offset = 0.12e-3, x = -0.05e-3, y = 0.08e-3, turn = 4e-3;  // [m], [rad]
};

/// The logarithmic spiral r = r0 exp(c angle): its normal leans by atan c against the radius everywhere, so that its support function is
/// known in closed form, h = r cos(tilt). Deviations by moving the nominal points: exact but for squares of the errors.
InspectionSheet spiral(const Made& made, std::size_t rows = 25) {
    const double c = 0.6, tilt = -std::atan(c);
    InspectionSheet sheet{"k_pe", {}};
    for (std::size_t i = 0; i < rows; ++i) {
        const double angle = 0.2 + 2.6 * static_cast<double>(i) / static_cast<double>(rows - 1), r = 6e-3 * std::exp(c * angle);
        InspectionRow row{Inspected::kContour, static_cast<int>(i + 1), r * std::cos(angle), r * std::sin(angle), 0.0, angle + tilt};
        row.nominal = r * std::cos(tilt);
        row.low = -0.3e-3;
        row.high = 0.3e-3;
        // A displacement of the contour's material at this place: offset along the normal, shift, turn about the axis.
        const double nx = std::cos(row.normal), ny = std::sin(row.normal);
        const double dx = made.offset * nx + made.x - made.turn * row.y, dy = made.offset * ny + made.y + made.turn * row.x;
        row.deviation = dx * nx + dy * ny;
        sheet.rows.push_back(row);
    }
    return sheet;
}

const core::Finding* found(const Calibration& c, const std::string& rule) {
    const auto f = std::find_if(c.findings.begin(), c.findings.end(), [&rule](const core::Finding& one) { return one.rule == rule; });
    return f == c.findings.end() ? nullptr : &*f;
}

TEST(InspectContour, RecoversOffsetEccentricityAndRotation) {
    const Made made;
    const ContourFit fit = fit_contour(spiral(made));
    ASSERT_TRUE(fit.shifts && fit.turns);
    EXPECT_NEAR(fit.offset.value, made.offset, 1e-12);
    EXPECT_NEAR(fit.x.value, made.x, 1e-12);
    EXPECT_NEAR(fit.y.value, made.y, 1e-12);
    EXPECT_NEAR(fit.rotation.value, made.turn, 1e-9);
    for (const double form : fit.form) EXPECT_NEAR(form, 0.0, 1e-12);
}

/// A contour that is made off, geometrically: each ray along the normal of the drawn spiral meets the spiral that was moved and widened.
TEST(InspectContour, RecoversThemFromAMovedCurveByRays) {
    const Made made;
    const double c = 0.6;
    InspectionSheet sheet = spiral({0.0, 0.0, 0.0, 0.0});
    for (InspectionRow& row : sheet.rows) {
        const double nx = std::cos(row.normal), ny = std::sin(row.normal);
        // Signed distance of a point from the moved spiral: move it back, then by Newton to the foot on r = r0 exp(c a) along its normal.
        const auto beyond = [&](double t) {
            const double px = row.x + t * nx - made.x, py = row.y + t * ny - made.y;
            const double ax = std::cos(made.turn) * px + std::sin(made.turn) * py,
                         ay = -std::sin(made.turn) * px + std::cos(made.turn) * py;
            double a = std::atan2(ay, ax);
            for (int i = 0; i < 50; ++i) {  // the foot: (p - s(a)).s'(a) = 0
                const auto slope = [&](double at) {
                    const double r = 6e-3 * std::exp(c * at), sx = r * std::cos(at), sy = r * std::sin(at);
                    return (ax - sx) * (c * sx - sy) + (ay - sy) * (c * sy + sx);
                };
                const double h = 1e-6;
                a -= slope(a) / ((slope(a + h) - slope(a - h)) / (2.0 * h));
            }
            const double r = 6e-3 * std::exp(c * a), tilt = -std::atan(c);
            return (ax - r * std::cos(a)) * std::cos(a + tilt) + (ay - r * std::sin(a)) * std::sin(a + tilt) - made.offset;
        };
        double low = -1e-3, high = 1e-3;
        for (int i = 0; i < 60; ++i) (beyond(0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
        row.deviation = 0.5 * (low + high);
    }
    const ContourFit fit = fit_contour(sheet);
    EXPECT_NEAR(fit.offset.value, made.offset, 3e-6);  // squares of the errors over the radius of curvature: 0.1^2/6 = 2e-3 mm
    EXPECT_NEAR(fit.x.value, made.x, 3e-6);
    EXPECT_NEAR(fit.y.value, made.y, 3e-6);
    EXPECT_NEAR(fit.rotation.value, made.turn, 1e-4);
}

/// Of 400 noisy sheets each interval holds the truth in 95 %: 362 is four deviations off (calibrate_test.cpp).
TEST(InspectContour, IntervalsHoldTheTruthAsOftenAsTheySay) {
    const Made made;
    std::mt19937_64 random(11);
    std::normal_distribution<double> noise(0.0, 0.02e-3);
    int offset = 0, x = 0, rotation = 0;
    for (int i = 0; i < 400; ++i) {
        InspectionSheet sheet = spiral(made);
        for (InspectionRow& row : sheet.rows) row.deviation += noise(random);
        const ContourFit fit = fit_contour(sheet);
        offset += fit.offset.interval().holds(made.offset);
        x += fit.x.interval().holds(made.x);
        rotation += fit.rotation.interval().holds(made.turn);
    }
    for (const int held : {offset, x, rotation}) EXPECT_GE(held, 362);
}

TEST(InspectContour, SaysWhatItIsForTheArmAndWhatToChange) {
    const Made made{0.3e-3, 0.0, 0.0, 0.0};
    const Calibration c = inspect_contour(spiral(made), {});
    const Figure* offset = c.find("contour_offset");
    ASSERT_NE(offset, nullptr);
    EXPECT_EQ(offset->key, "compensation.k_pe_contour_mm");
    EXPECT_TRUE(offset->changes());
    // The least arm is the first row's: 6 exp(0.12) cos(atan 0.6) = 5.80 mm, of which 0.3 is 5.17 %.
    const double percent = 100.0 * 0.3 / (6.0 * std::exp(0.12) / std::sqrt(1.36));
    ASSERT_EQ(c.remarks.size(), 1u);
    EXPECT_NE(c.remarks[0].find(fmt::format("{:+.2f} % as made, ", percent)), std::string::npos) << c.remarks[0];
    ASSERT_NE(found(c, "inspection.form"), nullptr);
    EXPECT_EQ(found(c, "inspection.form")->severity, core::Severity::kPass);
}

TEST(InspectContour, AWarningStatesEccentricityAndRotation) {
    const Calibration c = inspect_contour(spiral({0.0, 0.4e-3, -0.3e-3, 0.05}), {});
    const core::Finding *ecc = found(c, "inspection.eccentricity"), *turn = found(c, "inspection.rotation");
    ASSERT_TRUE(ecc && turn);
    EXPECT_EQ(ecc->severity, core::Severity::kWarning);
    EXPECT_NEAR(ecc->measured, 0.5, 1e-9);
    EXPECT_NE(ecc->suggestion.text().find("+0.400 mm along x and -0.300 mm along y"), std::string::npos) << ecc->suggestion.text();
    EXPECT_EQ(turn->severity, core::Severity::kWarning);
    EXPECT_NE(turn->what.find("+2.865 deg"), std::string::npos) << turn->what;  // 0.05 rad
    EXPECT_FALSE(c.find("contour_offset")->changes()) << "there is none";
}

/// Of a circle about the bore a turn changes nothing; of an eccentric one it looks like a shift.
TEST(InspectContour, DoesNotInventARotationThatTheContourCannotShow) {
    for (const double eccentricity : {0.0, 3e-3}) {
        InspectionSheet sheet{"k_se", {}};
        for (int i = 0; i < 24; ++i) {
            const double psi = 0.2 * i, nx = std::cos(psi), ny = std::sin(psi);
            InspectionRow row{Inspected::kContour, i + 1, 1e-2 * nx + eccentricity, 1e-2 * ny, 0.0, psi, 1e-2, -1e-4, 1e-4};
            row.deviation = 0.1e-3 + 0.02e-3 * nx;
            sheet.rows.push_back(row);
        }
        const Calibration c = inspect_contour(sheet, {});
        EXPECT_EQ(c.find("rotation"), nullptr);
        ASSERT_EQ(c.unknown.size(), 1u);
        EXPECT_EQ(c.unknown[0].id, "rotation");
        EXPECT_NEAR(c.find("eccentricity_x")->value, 0.02e-3, 1e-12);
    }
}

TEST(InspectContour, FewRowsGiveTheOffsetOnly) {
    InspectionSheet sheet = spiral({0.1e-3, 0.0, 0.0, 0.0});
    for (std::size_t i = 3; i < sheet.rows.size(); ++i) sheet.rows[i].deviation = kNone;
    const Calibration c = inspect_contour(sheet, {});
    EXPECT_NEAR(c.find("contour_offset")->value, 0.1e-3, 1e-12);
    EXPECT_EQ(c.unknown.size(), 2u);
}

TEST(InspectContour, OtherRowsAreJudgedOnTheSideThatTheyMiss) {
    InspectionSheet sheet = spiral({});
    sheet.rows.push_back({Inspected::kBore, 1, 0, 0, 0, kNone, 6.2e-3, -0.1e-3, 0.2e-3, -0.15e-3});
    sheet.rows.push_back({Inspected::kFace, 1, 0, 0, 0, kNone, 0.0, -0.1e-3, 0.1e-3, 0.05e-3});
    const Calibration c = inspect_contour(sheet, {});
    EXPECT_EQ(found(c, "inspection.bore")->severity, core::Severity::kWarning);
    EXPECT_NEAR(found(c, "inspection.bore")->measured, 0.15, 1e-12);
    EXPECT_NEAR(found(c, "inspection.bore")->allowed, 0.1, 1e-12);
    EXPECT_EQ(found(c, "inspection.face")->severity, core::Severity::kPass);
}

TEST(InspectContour, ARimHasNoPercentAndNoKey) {
    InspectionSheet sheet = spiral({});
    for (InspectionRow& row : sheet.rows) row.item = Inspected::kRim;
    const Calibration c = inspect_contour(sheet, {});
    EXPECT_EQ(c.find("contour_offset")->key, "");
    EXPECT_NE(c.remarks.at(0).find("slope of the rim"), std::string::npos);
}

/// The text of a sheet whose first row is filled.
std::string filled(const std::string& value, std::size_t row = 0) {
    std::string text = empty_inspection(spiral({}), "test");
    std::size_t at = text.find("measured_deviation_mm\n") + 22;  // of the header line
    for (std::size_t i = 0; i < row; ++i) at = text.find('\n', at) + 1;
    text.insert(text.find('\n', at), value);
    return text;
}

TEST(InspectionSheet, IsReadBackAsWritten) {
    const std::string text = filled("0.125");
    EXPECT_TRUE(is_inspection(text));
    EXPECT_FALSE(is_inspection("item,given,given_unit,measured,unit\n"));
    const InspectionSheet sheet = parse_inspection(text, "i.csv"), drawn = spiral({});
    ASSERT_EQ(sheet.rows.size(), drawn.rows.size());
    EXPECT_EQ(sheet.part, "k_pe");
    EXPECT_NEAR(sheet.rows[0].deviation, 0.125e-3, 1e-15);
    for (std::size_t i = 0; i < drawn.rows.size(); ++i) {
        EXPECT_NEAR(sheet.rows[i].x, drawn.rows[i].x, 0.5e-7);
        EXPECT_NEAR(sheet.rows[i].normal, drawn.rows[i].normal, 1e-6);
        EXPECT_NEAR(sheet.rows[i].nominal, drawn.rows[i].nominal, 0.5e-7);
        EXPECT_EQ(std::isnan(sheet.rows[i].deviation), i > 0);
    }
}

TEST(InspectionSheet, BadCellsAreNamedByFileLineAndColumn) {
    const auto refused = [](const std::string& text) { return field_refused([&] { return parse_inspection(text, "i.csv"); }); };
    EXPECT_EQ(refused(filled("")), "i.csv: measured_deviation_mm");
    // Five lines of comment and the header: the first row is line 7.
    EXPECT_TRUE(refused(filled("abc")).starts_with("i.csv:7:")) << refused(filled("abc"));
    EXPECT_NE(refused(filled("12.5", 1)).find("i.csv:8:"), std::string::npos) << "a radius instead of a deviation";
    EXPECT_NE(refused(filled("12.5", 1)).find("measured_deviation_mm"), std::string::npos);
    std::string other = filled("0.1");
    other.replace(other.rfind("k_pe,"), 5, "k_se,");
    EXPECT_NE(refused(other).find("part"), std::string::npos);
    std::string item = filled("0.1");
    item.replace(item.find("k_pe,contour"), 12, "k_pe,conture");
    EXPECT_NE(refused(item).find("item"), std::string::npos);
}

}  // namespace
}  // namespace fusee::coupon
