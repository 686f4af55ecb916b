#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "fusee/core/file.h"

// docs/theory tells the constants that the sources have; each one of the engine has its meaning beside it.
namespace fusee::diagnosis {
namespace {

std::string file(const std::string& name) { return core::read_file(std::filesystem::path(FUSEE_SOURCE_DIR) / name); }

/// "1.0, 0.7" or "{1.0, 0.7}" or "= 1.0" as numbers.
std::vector<double> numbers(std::string text) {
    for (char& c : text)
        if (c == '{' || c == '}' || c == ',' || c == '=') c = ' ';
    std::istringstream words(text);
    std::vector<double> all;
    for (double value = 0.0; words >> value;) all.push_back(value);
    return all;
}

struct Constant {
    std::string name, value, source;
};
/// The rows of both kinds of table: with a column that names the source, and those below a line "Of `SOURCE`:".
std::vector<Constant> told_by(const std::string& page) {
    std::istringstream lines(file(page));
    std::vector<Constant> all;
    std::string below;
    const auto quoted = [](const std::string& cell) { return cell.substr(cell.find('`') + 1, cell.rfind('`') - cell.find('`') - 1); };
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("Of `")) below = quoted(line);
        if (line.starts_with("| constant | value | in |")) below.clear();
        if (line.rfind("| `k", 0) != 0) continue;
        std::vector<std::string> cells;
        std::istringstream row(line.substr(2));
        for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell);
        all.push_back({quoted(cells.at(0)), cells.at(1), below.empty() ? quoted(cells.at(2)) : below});
    }
    return all;
}

std::vector<Constant> told() {
    std::vector<Constant> all;
    for (const char* page : {"docs/theory/diagnosis.md", "docs/theory/unknown.md"})
        for (Constant& constant : told_by(page)) all.push_back(std::move(constant));
    return all;
}

TEST(DiagnosisPage, TellsTheConstantsOfTheSources) {
    const std::vector<Constant> constants = told();
    EXPECT_GT(constants.size(), 20U);
    for (const Constant& constant : constants) {
        const std::string source = file(constant.source);
        std::size_t at = source.find(" " + constant.name + " =");
        if (at == std::string::npos) at = source.find(" " + constant.name + "{");
        ASSERT_NE(at, std::string::npos) << constant.name << " is not in " << constant.source;
        const std::size_t value = at + 1 + constant.name.size();
        EXPECT_EQ(numbers(constant.value), numbers(source.substr(value, source.find(';', value) - value))) << constant.name;
    }
}

TEST(Constants, OfTheEngineHaveTheirMeaningBesideThem) {
    const std::string table = file("include/fusee/inference/constants.h");
    const std::regex any("constexpr [a-z_:]+ k[A-Za-z0-9]+ ="), with_meaning("constexpr [a-z_:]+ (k[A-Za-z0-9]+) =\\s+[^;]+;\\s+///< \\S");
    const auto count = [&table](const std::regex& regex) {
        return std::distance(std::sregex_iterator(table.begin(), table.end(), regex), {});
    };
    EXPECT_GT(count(any), 50);
    EXPECT_EQ(count(with_meaning), count(any));
}

}  // namespace
}  // namespace fusee::diagnosis
