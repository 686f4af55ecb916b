#include "fusee/study/store.h"

#include <cmath>
#include <fstream>
#include <thread>

#include "fixture.h"

namespace fusee::study {
namespace {

class Store : public StudyFolder {
protected:
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
        RowLog log(folder_.path(), "1-of-1");
        for (std::size_t i = 0; i < 5; ++i) log.append(row(i));
    }
    const RowIndex rows(folder_.path());
    ASSERT_EQ(rows.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(rows.read(rows.find(row(i).key).value()), row(i)) << i;
    EXPECT_FALSE(rows.find(row(5).key).has_value());
}

TEST_F(Store, ANumberThatIsNotKnownStaysSo) {
    Row unknown = row(0);
    unknown.figures = {{"mass_g", std::nan("")}, {"reason", "a \"quoted\", text\nof two lines"}};
    const Row back = parse_row(to_json_line(unknown), "f");
    EXPECT_TRUE(std::isnan(std::get<double>(back.figures[0].second)));
    EXPECT_EQ(back.figures[1], unknown.figures[1]);
}

// A killed process leaves a part of its last line: any part of it is ignored, and the next rows are read.
TEST_F(Store, HalfALineIsIgnored) {
    const std::string last = to_json_line(row(2));
    for (std::size_t cut = 1; cut < last.size(); ++cut) {
        const core::TemporaryFolder place;
        {
            RowLog log(place.path(), "1-of-1");
            log.append(row(0));
            log.append(row(1));
        }
        std::ofstream(place.path() / "rows/1-of-1.jsonl", std::ios::app) << last.substr(0, cut);
        EXPECT_EQ(RowIndex(place.path()).size(), 2U) << cut;
        RowLog(place.path(), "1-of-1").append(row(3));
        const RowIndex rows(place.path());
        // the whole line without its end is a whole row
        EXPECT_EQ(rows.size(), cut + 1 == last.size() ? 4U : 3U) << cut;
        EXPECT_EQ(rows.read(rows.find(row(3).key).value()), row(3));
    }
}

TEST_F(Store, ManyThreadsWriteWholeLines) {
    {
        RowLog log(folder_.path(), "1-of-1");
        std::vector<std::jthread> threads;
        for (std::size_t t = 0; t < 4; ++t)
            threads.emplace_back([&log, t] {
                for (std::size_t i = 0; i < 50; ++i) log.append(row(50 * t + i));
            });
    }
    EXPECT_EQ(RowIndex(folder_.path()).size(), 200U);
}

TEST_F(Store, TheLogsOfAllShardsAreRead) {
    for (const char* shard : {"1-of-2", "2-of-2"}) RowLog(folder_.path(), shard).append(row(shard[0] == '1' ? 0 : 1));
    EXPECT_EQ(RowIndex(folder_.path()).size(), 2U);
}

}  // namespace
}  // namespace fusee::study
