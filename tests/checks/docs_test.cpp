#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "fusee/checks/limits.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"

// The tables of rules have a row for each rule; the defaults of docs/rules.md are those of the code.
namespace fusee::checks {
namespace {

std::string page() { return core::read_file(std::filesystem::path(FUSEE_SOURCE_DIR) / "docs/rules.md"); }

void expect_row(const std::string& text, const std::string& row) {
    EXPECT_NE(text.find(row), std::string::npos) << "docs/rules.md lacks: " << row;
}

TEST(Docs, TheTablesOfRulesHaveEveryRuleOnce) {
    const std::string text = rules_reference(), begin = "\n| `";
    std::set<std::string> ids;
    std::size_t rows = 0;
    for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at + 1)) {
        const std::size_t from = at + begin.size();
        const std::string id = text.substr(from, text.find('`', from) - from);
        ids.insert(id);
        ++rows;
    }
    EXPECT_EQ(rows, ids.size());
    for (const Rule& rule : rules()) EXPECT_TRUE(ids.erase(rule.id)) << rule.id;
    EXPECT_TRUE(ids.empty()) << *ids.begin() << " is not a rule";
}

TEST(Docs, DefaultTablesAreThoseOfTheCode) {
    const std::string text = page();
    for (const CableLimits& c : cable_table())
        expect_row(text, fmt::format("| {} | {:g} | {:g} | {:g} | {:g} | {:g} | {} |", c.construction, c.critical, c.recommended,
                                     c.friction, usual_cable(c.construction, 1e-3), strongest_cable(c.construction, 1e-3), c.source));
    const auto mm = [](double metres) { return metres > 0.0 ? fmt::format("{:g}", core::mm_from_m(metres)) : std::string("-"); };
    const auto number = [](double value) { return value > 0.0 ? fmt::format("{:g}", value) : std::string("-"); };
    for (const ProcessLimits& p : process_table()) {
        expect_row(text, fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {:g} to {:g} | {} | {:g} | {:g} |", to_string(p.kind),
                                     mm(p.wall), mm(p.loaded_wall), mm(p.hole), number(core::deg_from_rad(p.overhang)), mm(p.cutter_radius),
                                     mm(p.tolerance), mm(p.feature), mm(p.detail), core::mm_from_m(p.fit.low), core::mm_from_m(p.fit.high),
                                     mm(p.layer), 1e6 * p.roughness, 1e6 * p.fine_roughness));
        expect_row(text, fmt::format("- {}: {}", to_string(p.kind), p.source));
    }
    for (const KeySize& k : key_table())
        expect_row(text, fmt::format("| {:g} to {:g} | {:g} | {:g} | {:g} | {:g} |", core::mm_from_m(k.above), core::mm_from_m(k.up_to),
                                     core::mm_from_m(k.width), core::mm_from_m(k.height), core::mm_from_m(k.shaft_depth),
                                     core::mm_from_m(k.hub_depth)));
    for (const Material& m : material_table())
        expect_row(text,
                   fmt::format("| {} | {:g} | {:g} | {:g} | {:g} | {:.3g} | {:g} | {} | {} |", m.name, m.strength / 1e6, m.permanent / 1e6,
                               m.bearing / 1e6, m.modulus / 1e9, m.creep_modulus / 1e9, m.density / 1e3, m.designation, m.source));
    for (const TerminationLimits& t : termination_table())
        expect_row(text, fmt::format("| {} | {} | {:g} % | {:g} | {} |", to_string(t.kind), t.fibre ? "fibre" : "wire", 100.0 * t.strength,
                                     t.width, t.source));
}

}  // namespace
}  // namespace fusee::checks
