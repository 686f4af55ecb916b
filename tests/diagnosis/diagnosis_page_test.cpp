#include <gtest/gtest.h>

#include <sstream>

#include "fusee/core/file.h"

// docs/theory/diagnosis.md tells the constants that the sources have.
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
std::vector<Constant> progress() {
    std::istringstream lines(file("docs/theory/diagnosis.md"));
    std::vector<Constant> all;
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("| `k", 0) != 0) continue;
        std::vector<std::string> cells;
        std::istringstream row(line.substr(2));
        for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell);
        const auto quoted = [](const std::string& cell) { return cell.substr(cell.find('`') + 1, cell.rfind('`') - cell.find('`') - 1); };
        all.push_back({quoted(cells.at(0)), cells.at(1), quoted(cells.at(2))});
    }
    return all;
}

TEST(DiagnosisPage, TellsTheConstantsOfTheSources) {
    const std::vector<Constant> constants = progress();
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

}  // namespace
}  // namespace fusee::diagnosis
