#include "fusee/study/index.h"

#include <cmath>

#include "fixture.h"
#include "refused.h"

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
        query(folder_.path() / "i.sqlite", sql, [&](const std::vector<std::string>& cells) {
            for (const std::string& cell : cells) text += cell + "|";
            text += "\n";
        });
        return text;
    }
};

TEST_F(Index, CsvHasOneLineForEachDesign) {
    write_csv(folder_.path() / "i.csv", kColumns, rows);
    EXPECT_EQ(core::read_file(folder_.path() / "i.csv"),
              "number,name,outcome,mass_g\n0,a,made,2.5\n3,b,\"refused, \"\"why\"\"\",\n4,c,made,\n");
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
    EXPECT_EQ(core::read_file(folder_.path() / "i.sqlite"), before);
}

}  // namespace
}  // namespace fusee::study
