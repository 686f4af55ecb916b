#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/run.h"

namespace fusee::app {
namespace {

using Json = nlohmann::json;

TEST_F(Program, ListsRulesAsJson) {
    const Ended ended = run("rules --json");
    ASSERT_EQ(ended.code, 0);
    const Json rules = result_of(ended);
    ASSERT_GE(rules.size(), 60u);
    const std::string text = run("rules").out;
    for (const Json& rule : rules) {
        for (const char* key : {"rule", "group", "severity", "guards_against", "measured", "source"})
            EXPECT_FALSE(rule.at(key).get<std::string>().empty()) << rule.dump();
        EXPECT_TRUE(rule.at("rule").get<std::string>().starts_with(rule.at("group").get<std::string>() + "."));
        EXPECT_NE(text.find("\n  " + rule.at("rule").get<std::string>() + " "), std::string::npos) << rule.at("rule");
        for (const Json& limit : rule.at("limits")) {
            EXPECT_TRUE(limit.contains("default") != limit.contains("default_by")) << rule.dump();
            EXPECT_NE(text.find(limit.at("limit").get<std::string>() + " " + limit.at("bound").get<std::string>()), std::string::npos);
        }
    }
}

/// The lines of Markdown tables that begin with "| `NAME` |", by name.
std::multimap<std::string, std::string> rows_of(const std::string& markdown) {
    std::multimap<std::string, std::string> rows;
    std::istringstream lines(markdown);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("| `")) rows.emplace(line.substr(3, line.find('`', 3) - 3), line);
    return rows;
}

// The tables that the site of the documents shows (docs/rules.md): each rule once, with every limit, and its default or where it is from.
TEST_F(Program, PrintsATableRowForEveryRule) {
    const auto rows = rows_of(run("rules --markdown").out);
    const Json rules = result_of(run("rules --json"));
    EXPECT_EQ(rows.size(), rules.size());
    for (const Json& rule : rules) {
        ASSERT_EQ(rows.count(rule.at("rule")), 1u) << rule.at("rule");
        const std::string& row = rows.find(rule.at("rule"))->second;
        std::vector<std::string> words;
        for (const char* key : {"guards_against", "measured", "source"}) words.push_back(rule.at(key).get<std::string>());
        for (const Json& key : rule.at("needs_keys")) words.push_back("`" + key.get<std::string>() + "`");
        for (const Json& limit : rule.at("limits")) {
            const std::string bound = limit.at("bound") == "at most" ? " <= " : " >= ", name = limit.at("limit");
            const std::string value = limit.contains("default") ? fmt::format("{:g}", limit.at("default").get<double>()) : "";
            words.push_back("`" + name + "`" + bound + value);
            if (limit.contains("default_by")) words.push_back(limit.at("default_by").get<std::string>());
        }
        for (const std::string& word : words) EXPECT_NE(row.find(word), std::string::npos) << word << "\n" << row;
    }
    EXPECT_EQ(run("rules --markdown cable").code, 2) << "all rules or none";
}

// docs/profile.md: each key with its unit or values, default and meaning; a key of K_PE that is one of K_SE's stands there.
TEST_F(Program, PrintsATableRowForEveryKey) {
    const auto rows = rows_of(run("keys --markdown").out);
    for (const Json& key : result_of(run("keys --json"))) {
        const std::string path = key.at("key"), allowed = key.at("allowed"), unit = key.at("unit"), meaning = key.at("meaning");
        const std::string stated = key.at("required") ? "" : key.at("default").get<std::string>();
        const bool rounded = !stated.empty() && stated.size() > 16 && stated.find_first_not_of("0123456789.") == std::string::npos;
        const std::string value = key.at("required") ? "| required |" : rounded ? "| `" + stated.substr(0, 7) : "| `" + stated + "` |";
        const auto [begin, end] = rows.equal_range(path.substr(path.rfind('.') + 1));
        EXPECT_TRUE(std::any_of(begin, end,
                                [&](const auto& row) {
                                    const auto has = [&](const std::string& words) { return row.second.find(words) != std::string::npos; };
                                    return has(allowed.substr(allowed.rfind(", ") + 1)) && has(unit) && has(value) && has(meaning);
                                }))
            << path << ": " << allowed << ", " << value << ", " << meaning;
    }
}

TEST_F(Program, AnOverriddenLimitStandsInTheReport) {
    write("t.toml", core::read_file(folder_ / quick("pnrvsa")) +
                        "\n[[limits]]\nrule = \"fdm.support\"\nreview_mm2 = 300\nreason = \"soluble supports\"\n");
    const Ended made = run("make t.toml");
    ASSERT_EQ(made.code, 0) << made.all();
    EXPECT_EQ(made.out.find("fdm.support"), std::string::npos) << "allowed now, so there is nothing to review: " << made.out;
    const Json report = Json::parse(core::read_file(folder_ / "out" / "pnrvsa" / "report.json"));
    bool found = false;
    for (const Json& part : report.at("parts"))
        for (const Json& f : part.at("findings")) {
            if (f.at("rule") != "fdm.support") continue;
            found = true;
            EXPECT_EQ(f.at("severity"), "pass");
            const Json expected = {
                {"limit", "review_mm2"}, {"value", 300.0}, {"default", 25.0}, {"unit", "mm^2"}, {"reason", "soluble supports"}};
            EXPECT_EQ(f.at("overridden"), Json::array({expected}));
            EXPECT_NE(f.at("what").get<std::string>().find("soluble supports"), std::string::npos);
        }
    EXPECT_TRUE(found);
}

TEST_F(Program, AWrongOverrideIsBadInput) {
    write("t.toml",
          core::read_file(fixtures::shipped("pnrvsa")) + "\n[[limits]]\nrule = \"process.wal\"\nrequired_mm = 1\nreason = \"x\"\n");
    const Ended wrong = run("make t.toml");
    EXPECT_EQ(wrong.code, 2);
    expect_words(wrong.err, {"t.toml:", "limits.rule", "process.wall"});
}

}  // namespace
}  // namespace fusee::app
