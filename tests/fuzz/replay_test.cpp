// What the fuzzers start from and what they found, read again: each file is read or refused with a message. The fuzzers themselves are
// outside CI (docs/robustness.md); here each reader gets a few hundred changed seeds. FUSEE_MUTATIONS=100000 makes that many.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/exchange/mesh_file.h"
#include "readers.h"

namespace fs = std::filesystem;

namespace fusee::fuzz {
namespace {

using Generator = std::mt19937_64;  // its numbers are the same everywhere; distributions' are not

std::size_t below(Generator& g, std::size_t count) { return count == 0 ? 0 : g() % count; }

/// One to three changes of bytes, pieces, lines and numbers.
std::string changed(std::string text, Generator& g) {
    static constexpr const char* kNumbers[] = {"nan", "-1", "0", "1e400", "-inf", "", "1e-320", "18446744073709551616", "-0.0", "1e308"};
    for (std::size_t changes = 1 + below(g, 3); changes > 0 && !text.empty(); --changes) {
        const std::size_t at = below(g, text.size());
        switch (below(g, 6)) {
            case 0:
                text[at] = static_cast<char>(g());
                break;
            case 1:
                text.erase(at, 1 + below(g, 40));
                break;
            case 2:
                text.insert(at, text.substr(below(g, text.size()), 1 + below(g, 200)));
                break;
            case 3: {  // a line goes
                const std::size_t before = text.rfind('\n', at), begin = before == std::string::npos ? 0 : before;
                text.erase(begin, std::min(text.find('\n', at), text.size()) - begin);
                break;
            }
            case 4:
                text.resize(at);
                break;
            default: {
                const std::size_t begin = std::min(text.find_first_of("0123456789", at), text.size());
                const std::size_t end = std::min(text.find_first_not_of("0123456789.eE+-", begin), text.size());
                text.replace(begin, end - begin, kNumbers[below(g, std::size(kNumbers))]);
            }
        }
    }
    return text;
}

int mutations() {
    const char* wanted = std::getenv("FUSEE_MUTATIONS");
    return wanted == nullptr ? 400 : std::atoi(wanted);
}

class EachReader : public testing::TestWithParam<const char*> {
protected:
    const Reader& reader_ = *reader(GetParam());
};

TEST_P(EachReader, AcceptsASeed) {
    std::size_t accepted = 0;
    for (const fs::path& seed : seeds(reader_)) accepted += accepts(reader_, core::read_file(seed)) ? 1 : 0;
    EXPECT_GT(accepted, 0u);  // else the fuzzer would only see refusals
}

class OwnReader : public EachReader {};  // of third-party readers: app.MeshMutation

TEST_P(OwnReader, RefusesOrReadsChangedSeeds) {
    Generator g(1);
    std::vector<std::string> texts;
    for (const fs::path& seed : seeds(reader_)) texts.push_back(core::read_file(seed));
    int accepted = 0;
    for (int i = 0; i < mutations(); ++i) {
        const std::string text = changed(texts[below(g, texts.size())], g);
        ASSERT_NO_THROW(accepted += accepts(reader_, text) ? 1 : 0) << "mutation " << i << ":\n" << text;
    }
    EXPECT_LT(accepted, mutations());
    RecordProperty("accepted", accepted);
}

// Each is a file that once crashed a reader, was read for ever or ended with an exception that is no refusal.
TEST(Reproducers, AreRefusedOrRead) {
    const fs::path folder = fs::path(FUSEE_SOURCE_DIR) / "tests/fuzz/reproducers";
    std::size_t files = 0;
    for (const Reader& each : readers()) {
        if (!fs::is_directory(folder / each.name)) continue;
        for (const auto& entry : fs::directory_iterator(folder / each.name)) {
            ++files;
            if (each.third_party)  // in its own process, as fusee check reads it
                EXPECT_THROW((void)exchange::read_mesh_isolated(entry.path(), {FUSEE_PROGRAM, exchange::kReadMesh}), core::InputError)
                    << entry.path();
            else
                EXPECT_NO_THROW((void)accepts(each, core::read_file(entry.path()))) << entry.path();
        }
    }
    RecordProperty("files", static_cast<int>(files));
}

std::vector<const char*> names(bool third_party) {
    std::vector<const char*> all;
    for (const Reader& each : readers())
        if (third_party || !each.third_party) all.push_back(each.name);
    return all;
}
std::string name_of(const testing::TestParamInfo<const char*>& test) { return "_" + std::string(test.param); }

INSTANTIATE_TEST_SUITE_P(All, EachReader, testing::ValuesIn(names(true)), name_of);
INSTANTIATE_TEST_SUITE_P(All, OwnReader, testing::ValuesIn(names(false)), name_of);

}  // namespace
}  // namespace fusee::fuzz
