#include "fusee/study/store.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cmath>
#include <fstream>
#include <thread>

#include "fixture.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"

namespace fs = std::filesystem;

namespace fusee::study {
namespace {

class Store : public StudyFolder {
protected:
    [[nodiscard]] core::OutputFolder place() const { return {folder_.path(), {.command = "batch", .among_others = true}}; }
    void put(const std::string& name, const std::string& text) const {
        fs::create_directories(folder_.path() / "rows");
        std::ofstream(folder_.path() / "rows" / name) << text;
    }
    static Row row(std::size_t index) {
        return {core::sha256_hex(std::to_string(index)),
                index,
                "design-" + std::to_string(index),
                {{"mass_g", 0.1 * static_cast<double>(index)}, {"outcome", "made"}},
                0.25};
    }
};

TEST_F(Store, RowsComeBack) {
    {
        RowLog log(place(), "1-of-1");
        EXPECT_FALSE(fs::exists(folder_.path() / "rows")) << "no row, no file";
        for (std::size_t i = 0; i < 5; ++i) log.append(row(i));
    }
    const RowIndex rows(place());
    ASSERT_EQ(rows.size(), 5U);
    EXPECT_EQ(rows.bad().count, 0U);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(rows.read(rows.find(row(i).key, row(i).name).value()), row(i)) << i;
    EXPECT_FALSE(rows.find(row(5).key, row(5).name).has_value());
    EXPECT_FALSE(rows.find(row(1).key, row(2).name).has_value()) << "a row of another design";
}

TEST_F(Store, ANumberThatIsNotKnownStaysSo) {
    Row unknown = row(0);
    unknown.figures = {{"mass_g", std::nan("")}, {"reason", "a \"quoted\", text\nof two lines, \xff"}};
    std::string line = to_json_line(unknown);
    line.pop_back();
    const Row back = parse_row(line, "f");
    EXPECT_TRUE(std::isnan(std::get<double>(back.figures[0].second)));
    EXPECT_TRUE(std::get<std::string>(back.figures[1].second).starts_with("a \"quoted\", text\nof two lines, "));
}

// A killed process leaves a part of its last line: it is named, and the next process writes to a file of its own.
TEST_F(Store, HalfALineIsNamedAndLeftOut) {
    const std::string last = to_json_line(row(2));
    for (std::size_t cut = 1; cut < last.size(); cut += 7) {
        put("1-of-1.jsonl", to_json_line(row(0)) + to_json_line(row(1)) + last.substr(0, cut));
        const RowIndex rows(place());
        EXPECT_EQ(rows.size(), 2U) << cut;
        ASSERT_EQ(rows.bad().count, 1U) << cut;
        EXPECT_NE(rows.bad().first[0].find("rows/1-of-1.jsonl:3: has no checksum"), std::string::npos) << rows.bad().first[0];
    }
    put("1-of-1.jsonl", to_json_line(row(0)) + last.substr(0, last.size() - 1));
    EXPECT_EQ(RowIndex(place()).size(), 2U) << "the whole line without its end is a whole row";
    RowLog(place(), "1-of-1").append(row(3));
    EXPECT_EQ(core::read_file(folder_.path() / "rows/1-of-1.2.jsonl"), to_json_line(row(3)));
    EXPECT_EQ(RowIndex(place()).size(), 3U);
}

/// The line with a valid checksum, whatever it says.
std::string forged(const std::string& begin) { return begin + R"(,"sha256":")" + core::sha256_hex(begin) + "\"}"; }

TEST_F(Store, WhatIsNoRowIsNamedWithItsLineAndReason) {
    const std::string good = to_json_line(row(0)), whole = good.substr(0, good.find(",\"sha256\""));
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = whole;
        text.replace(text.find(from), from.size(), to);
        return forged(text);
    };
    std::string changed = good;
    changed.replace(changed.find("0.25"), 4, "0.26");
    const std::vector<std::pair<std::string, std::string>> bad{
        {whole + "}", "has no checksum"},
        {changed.substr(0, changed.size() - 1), "was changed"},
        {R"({"key":"zzz)", "has no checksum"},
        {forged(R"({"key":"zzz)"), "JSON"},
        {std::string("\0\0\0", 3), "has no checksum"},
        {"", "has no checksum"},
        {"[[[[", "has no checksum"},
        {forged(R"({"key":"z")"), "index"},
        {with(row(0).key, std::string(64, 'z')), "64 digits"},
        {with("\"index\":0", "\"index\":-1"), "index"},
        {with("\"index\":0", "\"index\":0,\"index\":1"), "each once"},
        {with("\"mass_g\":0.0", "\"mass_g\":NaN"), "JSON"},
        {with("\"mass_g\":0.0", "\"mass_g\":1e999"), "at most"},
        {with("\"mass_g\":0.0", "\"mass_g\":[1]"), "mass_g"},
        {with("\"mass_g\":0.0", "\"mass_g\":0.0,\"mass_g\":1.0"), "each once"},
        {with("\"seconds\":0.25", "\"seconds\":\"0.25\""), "seconds"},
        {with("{\"key\"", "{ \"key\""), "each once"},
        {with("\"outcome\":\"made\"", "\"outcome\":" + std::string(100, '[')), "deep"},
        {std::string(2'000'000, 'x'), "longer than"},
    };
    std::string text;
    for (const auto& [line, why] : bad) text += line + "\n";
    put("1-of-1.jsonl", text + to_json_line(row(1)));
    const RowIndex rows(place());
    EXPECT_EQ(rows.size(), 1U);
    ASSERT_EQ(rows.bad().count, bad.size());
    ASSERT_EQ(rows.bad().first.size(), bad.size());
    for (std::size_t i = 0; i < bad.size(); ++i) {
        EXPECT_NE(rows.bad().first[i].find(fmt::format("1-of-1.jsonl:{}:", i + 1)), std::string::npos) << rows.bad().first[i];
        EXPECT_NE(rows.bad().first[i].find(bad[i].second), std::string::npos) << rows.bad().first[i] << " lacks " << bad[i].second;
    }
}

TEST_F(Store, ASecondRowOfADesignThatDiffersIsNamed) {
    Row slower = row(0), other = row(0);
    slower.seconds = 2.0;
    other.figures[0].second = 7.0;
    put("a.jsonl", to_json_line(row(0)) + to_json_line(slower) + to_json_line(other));
    const RowIndex rows(place());
    EXPECT_EQ(rows.read(rows.find(row(0).key, row(0).name).value()), row(0));
    ASSERT_EQ(rows.bad().count, 1U);
    EXPECT_NE(rows.bad().first[0].find("a.jsonl:3: has other figures"), std::string::npos) << rows.bad().first[0];
}

TEST_F(Store, LinksPipesAndFoldersAmongTheLogsAreNotRead) {
    put("a.jsonl", to_json_line(row(0)));
    std::ofstream(folder_.path() / "victim.jsonl") << to_json_line(row(1));
    fs::create_symlink(folder_.path() / "victim.jsonl", folder_.path() / "rows/b.jsonl");
    fs::create_directories(folder_.path() / "rows/c.jsonl");
    ASSERT_EQ(::mkfifo((folder_.path() / "rows/d.jsonl").c_str(), 0666), 0);
    const RowIndex rows(place());
    EXPECT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows.bad().count, 3U);
}

// Rows are never written to a file that exists: not to a link's target, not to a file of two names.
TEST_F(Store, NothingIsAppendedToWhatExists) {
    const fs::path rows = folder_.path() / "rows", victim = folder_.path() / "victim";
    std::ofstream(victim) << "mine";
    fs::create_directories(rows);
    fs::create_hard_link(victim, rows / "1-of-1.jsonl");
    RowLog(place(), "1-of-1").append(row(0));
    EXPECT_EQ(core::read_file(victim), "mine");
    fs::remove(rows / "1-of-1.jsonl");
    for (const fs::path& to : {victim, folder_.path() / "gone"}) {
        fs::create_symlink(to, rows / "1-of-1.jsonl");
        EXPECT_THROW(RowLog(place(), "1-of-1"), core::IoError);
        fs::remove(rows / "1-of-1.jsonl");
    }
    fs::rename(rows, folder_.path() / "elsewhere");
    fs::create_directory_symlink(folder_.path() / "elsewhere", rows);
    EXPECT_THROW(RowLog(place(), "1-of-1"), core::IoError);
    EXPECT_THROW(RowIndex{place()}, core::IoError);
    EXPECT_EQ(core::read_file(victim), "mine");
    EXPECT_FALSE(fs::exists(folder_.path() / "gone"));
}

TEST_F(Store, ManyThreadsWriteWholeLines) {
    {
        RowLog log(place(), "1-of-1");
        std::vector<std::jthread> threads;
        for (std::size_t t = 0; t < 4; ++t)
            threads.emplace_back([&log, t] {
                for (std::size_t i = 0; i < 50; ++i) log.append(row(50 * t + i));
            });
    }
    EXPECT_EQ(RowIndex(place()).size(), 200U);
}

TEST_F(Store, TheLogsOfAllShardsAreRead) {
    for (const char* shard : {"1-of-2", "2-of-2"}) RowLog(place(), shard).append(row(shard[0] == '1' ? 0 : 1));
    EXPECT_EQ(RowIndex(place()).size(), 2U);
}

}  // namespace
}  // namespace fusee::study
