#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "fusee/checks/limits.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"

// docs/checks.md says what the code does: every rule has its row, every default its number.
namespace fusee::checks {
namespace {

std::string page() { return core::read_file(std::filesystem::path(FUSEE_SOURCE_DIR) / "docs/checks.md"); }

void expect_row(const std::string& text, const std::string& row) {
    EXPECT_NE(text.find(row), std::string::npos) << "docs/checks.md lacks: " << row;
}

TEST(Docs, EveryRuleHasItsRow) {
    const std::string text = page();
    std::set<std::string> ids;
    for (const Rule& rule : rules()) {
        EXPECT_TRUE(ids.insert(rule.id).second) << rule.id << " twice";
        expect_row(text, fmt::format("| `{}` | {} |", rule.id, rule.title));
    }
}

TEST(Docs, NoRowIsLeftOfARuleThatIsGone) {
    std::set<std::string> ids;
    for (const Rule& rule : rules()) ids.insert(rule.id);
    const std::string text = page(), begin = "\n| `";
    std::size_t rows = 0;
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1), ++rows) {
        const std::size_t from = at + begin.size();
        EXPECT_TRUE(ids.count(text.substr(from, text.find('`', from) - from))) << text.substr(from, 30);
    }
    EXPECT_EQ(rows, ids.size());
}

TEST(Docs, DefaultTablesAreThoseOfTheCode) {
    const std::string text = page();
    for (const CableLimits& c : cable_table())
        expect_row(text, fmt::format("| {} | {:g} | {:g} | {} |", c.construction, c.critical, c.recommended, c.source));
    const auto mm = [](double metres) { return metres > 0.0 ? fmt::format("{:g}", core::mm_from_m(metres)) : std::string("-"); };
    for (const ProcessLimits& p : process_table())
        expect_row(text, fmt::format("| {} | {} | {} | {} | {} | {} | {} |", to_string(p.kind), mm(p.wall), mm(p.loaded_wall), mm(p.hole),
                                     p.overhang > 0.0 ? fmt::format("{:g}", core::deg_from_rad(p.overhang)) : "-", mm(p.cutter_radius),
                                     mm(p.tolerance)));
    for (const KeySize& k : key_table())
        expect_row(text, fmt::format("| {:g} to {:g} | {:g} | {:g} |", core::mm_from_m(k.above), core::mm_from_m(k.up_to),
                                     core::mm_from_m(k.width), core::mm_from_m(k.hub_depth)));
}

}  // namespace
}  // namespace fusee::checks
