#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "exchange/fixtures/parts.h"
#include "fusee/core/file.h"
#include "fusee/toolpath/program.h"
#include "fusee/toolpath/read_back.h"

/// Small parts, programs as numbers, and a folder to interpret them in.
namespace fusee::toolpath {

inline solid::Part part_of(const cam::Cam& cam, const solid::PartOptions& options = fixtures::keyed_options()) {
    const auto part = solid::outline_part(cam, options);
    if (!part) throw std::runtime_error(core::to_line(part.refusal().front()));
    return *part;
}

/// A disc about (e, 0), with a floor known by hand: h = R + e cos psi, less half a cable of 1 mm.
inline solid::Part disc(double offset = 2e-3) { return part_of(fixtures::planar_cam(12e-3, offset)); }

inline solid::Part helix() {
    solid::PartOptions options = fixtures::keyed_options();
    options.groove.rib = 1e-3;
    return part_of(fixtures::helix_cam(), options);
}

/// The words of one line by their letters: G1 X2 Y3 gives {'G': 1, 'X': 2, 'Y': 3}.
using Words = std::map<char, double>;
inline std::vector<Words> lines_of(const std::string& program) {
    std::vector<Words> lines;
    std::istringstream text(program);
    for (std::string line; std::getline(text, line);) {
        if (line.empty() || line.front() == '(' || line.front() == '#' || line.find('[') != std::string::npos) continue;
        Words words;
        std::istringstream row(line);
        for (std::string word; row >> word;)
            if (word.size() > 1 && word.front() != 'D') words[word.front()] = std::stod(word.substr(1));
        lines.push_back(words);
    }
    return lines;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    EXPECT_NE(text.find(from), std::string::npos) << from;
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) text.replace(at, from.size(), to);
    return text;
}

/// Tests that need LinuxCNC's interpreter; they skip where it is missing.
class InterpreterTest : public ::testing::Test {
protected:
    void SetUp() override {
        if (!can_interpret()) GTEST_SKIP() << "rs274 (package linuxcnc-uspace) is not installed";
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::path(::testing::TempDir()) / (std::string("fusee_toolpath_") + info->name());
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override {
        if (!folder_.empty()) std::filesystem::remove_all(folder_);
    }
    [[nodiscard]] Interpreted run(const std::string& text) const {
        core::write_file(folder_ / "program.ngc", text);
        return interpret(folder_ / "program.ngc");
    }
    std::filesystem::path folder_;
};

}  // namespace fusee::toolpath
