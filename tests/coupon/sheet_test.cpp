#include "fusee/coupon/sheet.h"

#include <gtest/gtest.h>

#include "refused.h"

namespace fusee::coupon {
namespace {

const Drawn kDrawn{0.8, 15.0, 6.0, {16.0, 66.0}, {16.0, 66.0}, {5.0, 25.0}, {6.0, 6.1, 6.2}, {0.5, 0.53}, 3.0};

std::string sheet(const std::string& row) { return "item,given,given_unit,measured,unit\nlength_x,66,mm,65.8,mm\n" + row + "\n"; }

TEST(SheetFile, IsReadRowByRow) {
    const Sheet read = parse_sheet(sheet("disc_floor,15,mm,,-\nshaft_enters,6.2,mm,1,1=yes 0=no\nlength_y,66,mm,,mm"), "c.csv");
    EXPECT_EQ(read.disc_floor_mm, 15.0);
    ASSERT_EQ(read.rows.size(), 2u) << "nominal values and empty cells are not rows";
    EXPECT_EQ(read.rows[0].item, Item::kLengthX);
    EXPECT_EQ(read.rows[0].measured, 65.8);
    EXPECT_EQ(read.of(Item::kShaftEnters).size(), 1u);
}

TEST(SheetFile, AnEmptyOneIsReadAsEveryRowWantsIt) {
    std::string text = empty_sheet(kDrawn, "fusee");
    EXPECT_EQ(field_refused([&] { return parse_sheet(text, "c.csv"); }), "c.csv: measured") << "nothing is filled";
    for (std::size_t at = 0; (at = text.find(",,mm\n", at)) != std::string::npos;) text.insert(at + 1, "5.0");
    const Sheet read = parse_sheet(text, "c.csv");
    EXPECT_EQ(read.cable_diameter_mm, 0.8);
    EXPECT_EQ(read.of(Item::kLengthX).size(), 6u) << "three times each of two lengths";
    EXPECT_EQ(read.of(Item::kBore).size(), 3u);
    EXPECT_EQ(read.of(Item::kDiscPull).back().given, 3.0);
    for (const ItemKind& kind : item_kinds()) EXPECT_NE(text.find(std::string("\n") + kind.name + ","), std::string::npos) << kind.name;
    const std::string page = readme(kDrawn, "fusee");
    for (const ItemKind& kind : item_kinds()) EXPECT_NE(page.find(kind.how), std::string::npos) << kind.name;
}

/// The error, and the place in its message.
TEST(SheetFile, NamesLineAndColumnOfWhatIsWrong) {
    const std::pair<const char*, const char*> wrong[] = {
        {"lenght_x,66,mm,65,mm", "c.csv:3:1: item"},           {"length_x,66,cm,65,mm", "c.csv:3:13: given_unit"},
        {"length_x,66,mm,65,inch", "c.csv:3:19: unit"},        {"length_x,-66,mm,65,mm", "c.csv:3:10: given"},
        {"length_x,66,mm,65 mm,mm", "c.csv:3:16: measured"},   {"length_x,66,mm,1e9,mm", "c.csv:3:16: measured"},
        {"length_x,,mm,65,mm", "c.csv:3:10: given"},           {"shaft_enters,6.2,mm,0.5,1=yes 0=no", "c.csv:3:21: measured"},
        {"disc_floor,15,mm,14.9,-", "c.csv:3:18: measured"},   {"disc_floor,15,mm,,-\ndisc_floor,16,mm,,-", "c.csv:4:12: given"},
        {"length_x,66,mm,65,mm,once more", "c.csv:3:22: row"},
    };
    for (const auto& [row, place] : wrong)
        EXPECT_EQ(field_refused([text = row] { return parse_sheet(sheet(text), "c.csv"); }), place) << row;
    EXPECT_EQ(field_refused([] { return parse_sheet("item,given\n", "c.csv"); }), "c.csv:1:11: header");
}

}  // namespace
}  // namespace fusee::coupon
