#include <sqlite3.h>
#include <sys/stat.h>

#include <chrono>
#include <cmath>

#include "fixture.h"
#include "fusee/study/store.h"
#include "refused.h"

namespace fs = std::filesystem;

namespace fusee::study {
namespace {

const std::vector<Column> kColumns{{"outcome", "made or refused", true}, {"mass_g", "mass [g]"}};

void rows(const std::function<void(const Row&)>& take) {
    take({"", 0, "a", {{"mass_g", 2.5}, {"outcome", "made"}}, 0.0});
    take({"", 3, "b", {{"outcome", "refused, \"why\""}}, 0.0});
    take({"", 4, "c", {{"mass_g", std::nan("")}, {"outcome", "made"}}, 0.0});
}

class Index : public StudyFolder {
protected:
    std::string answer(const std::string& sql) const {
        std::string text;
        rows_ = 0;
        query(folder_.path() / "i.sqlite", sql, kTime, [&](const std::vector<std::string>& cells) {
            for (const std::string& cell : cells) text += cell.substr(0, 20) + "|";
            text += "\n";
            return ++rows_ < 1000;
        });
        return text;
    }
    bool is_refused(const std::string& sql) const {
        try {
            return (void)answer(sql), false;
        } catch (const core::InputError&) {
            return true;
        }
    }
    /// The index of another person, who also wrote `sql` into it.
    void forge(const std::string& sql) const {
        const fs::path file = folder_.path() / "i.sqlite";
        write_sqlite(file, kColumns, rows);
        sqlite3* database = nullptr;
        ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
        char* why = nullptr;
        EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &why), SQLITE_OK) << why;
        sqlite3_close(database);
    }

    static constexpr std::chrono::seconds kTime{1};
    mutable int rows_ = 0;
};

TEST_F(Index, CsvHasOneLineForEachDesign) {
    write_csv(folder_.path() / "i.csv", kColumns, rows);
    EXPECT_EQ(core::read_file(folder_.path() / "i.csv"),
              "number,name,outcome,mass_g\n0,a,made,2.5\n3,b,\"refused, \"\"why\"\"\",\n4,c,made,\n");
}

// A spreadsheet would run it: the apostrophe makes it a text.
TEST_F(Index, AFormulaIsAText) {
    write_csv(folder_.path() / "i.csv", {{"outcome", "", true}}, [](const auto& take) {
        for (const char* text : {"=1+1", "+cmd|' /C calc'!A0", "-2+3", "@SUM(A1)", "\t=1", "\r=1", "-2.5", "+3e4", "-", "a=1"})
            take({"", 0, "a", {{"outcome", text}}, 0.0});
    });
    EXPECT_EQ(core::read_file(folder_.path() / "i.csv"),
              "number,name,outcome\n0,a,\"'=1+1\"\n0,a,\"'+cmd|' /C calc'!A0\"\n0,a,\"'-2+3\"\n0,a,\"'@SUM(A1)\"\n0,a,\"'\t=1\"\n"
              "0,a,\"'\r=1\"\n0,a,-2.5\n0,a,+3e4\n0,a,-\n0,a,a=1\n");
}

TEST_F(Index, SqliteAnswersAndHasTheSameBytesEachTime) {
    for (const char* name : {"i.sqlite", "j.sqlite"}) write_sqlite(folder_.path() / name, kColumns, rows);
    EXPECT_EQ(answer("SELECT number, name, mass_g FROM designs WHERE mass_g IS NULL ORDER BY number"),
              "number|name|mass_g|\n3|b||\n4|c||\n");
    EXPECT_EQ(answer("SELECT meaning FROM columns WHERE name = 'mass_g'"), "meaning|\nmass [g]|\n");
    EXPECT_EQ(core::read_file(folder_.path() / "i.sqlite"), core::read_file(folder_.path() / "j.sqlite"));
}

TEST_F(Index, AQueryOnlyReads) {
    write_sqlite(folder_.path() / "i.sqlite", kColumns, rows);
    const std::string before = core::read_file(folder_.path() / "i.sqlite");
    for (const char* sql : {"DELETE FROM designs", "DROP TABLE designs", "SELECT 1; DELETE FROM designs", "SELEC 1", ""})
        EXPECT_NE(field_refused([&] { return answer(sql); }), "accepted") << sql;
    try {
        (void)answer("DROP TABLE designs");
        FAIL();
    } catch (const core::InvalidInput& e) {
        EXPECT_EQ(e.value(), "the index is only read");
    }
    EXPECT_EQ(core::read_file(folder_.path() / "i.sqlite"), before);
}

constexpr const char* kEndless = "WITH RECURSIVE n(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM n) SELECT ";

TEST_F(Index, AQueryEnds) {
    write_sqlite(folder_.path() / "i.sqlite", kColumns, rows);
    for (const char* what : {"max(x) FROM n", "x FROM n ORDER BY x DESC", "count(*) FROM n, n AS m, designs"}) {
        const auto begin = std::chrono::steady_clock::now();
        EXPECT_TRUE(is_refused(std::string(kEndless) + what)) << what;
        EXPECT_LT(std::chrono::steady_clock::now() - begin, 10 * kTime) << what;
    }
    EXPECT_NE(answer(std::string(kEndless) + "x FROM n").find("999|"), std::string::npos);
    EXPECT_EQ(rows_, 1000) << "until nobody takes more: a head and 999 numbers";
    for (const char* sql : {"SELECT zeroblob(900000000)", "SELECT length(randomblob(1e9))"}) EXPECT_TRUE(is_refused(sql)) << sql;
}

TEST_F(Index, AQueryReadsTablesOfThisFileOnly) {
    write_sqlite(folder_.path() / "i.sqlite", kColumns, rows);
    const std::string other = (folder_.path() / "other.sqlite").string();
    for (const std::string& sql : {"ATTACH '" + other + "' AS o", std::string("PRAGMA temp_store_directory = '/'"),
                                   std::string("SELECT load_extension('x')"), "VACUUM INTO '" + other + "'"})
        EXPECT_TRUE(is_refused(sql)) << sql;
    EXPECT_FALSE(fs::exists(other));
    EXPECT_NE(answer("PRAGMA table_info(designs)").find("mass_g"), std::string::npos);
}

TEST_F(Index, AForgedViewIsNotAsked) {
    forge("ALTER TABLE designs RENAME TO d; CREATE VIEW designs AS " + std::string(kEndless) + "x AS mass_g FROM n");
    EXPECT_TRUE(is_refused("SELECT mass_g FROM designs"));
    forge("CREATE VIEW more AS " + std::string(kEndless) + "x FROM n");
    EXPECT_TRUE(is_refused("SELECT * FROM more"));
    EXPECT_NE(answer("SELECT name FROM designs").find("a|"), std::string::npos) << "the rest can be asked";
}

// SQLite would look into a journal beside the file, and wait for the pipe's writer.
TEST_F(Index, APipeAsJournalIsNotOpened) {
    write_sqlite(folder_.path() / "i.sqlite", kColumns, rows);
    for (const char* name : {"i.sqlite-journal", "i.sqlite-wal"}) ASSERT_EQ(::mkfifo((folder_.path() / name).c_str(), 0600), 0);
    EXPECT_NE(answer("SELECT name FROM designs").find("a|"), std::string::npos);
}

TEST_F(Index, ANameOfAnyLettersIsFound) {
    const fs::path odd = folder_.path() / "50 % of #1?mode=rwc&x";
    fs::create_directory(odd);
    write_sqlite(odd / "i.sqlite", kColumns, rows);
    int count = 0;
    query(odd / "i.sqlite", "SELECT name FROM designs", kTime, [&](const auto&) { return ++count > 0; });
    EXPECT_EQ(count, 4);
}

}  // namespace
}  // namespace fusee::study
