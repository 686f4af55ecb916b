#include "fusee/core/file_watch.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/temporary_folder.h"

namespace fusee::core {
namespace {

using std::chrono::milliseconds;
constexpr milliseconds kNow{0}, kLong{2000}, kQuiet{5};

TEST(FileWatch, SeesASaveAReplacementAndANewFile) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "a.toml", other = folder.path() / "b.toml";
    FileWatch watch;
    watch.watch({file});
    EXPECT_FALSE(watch.wait(kNow, kQuiet));
    write_file(file, "1");  // writes a temporary name and renames it
    EXPECT_TRUE(watch.wait(kLong, kQuiet));
    write_file(other, "1");
    EXPECT_FALSE(watch.wait(milliseconds(50), kQuiet)) << "another file of the folder";
    std::filesystem::rename(other, file);
    EXPECT_TRUE(watch.wait(kLong, kQuiet));
    std::filesystem::remove(file);
    EXPECT_TRUE(watch.wait(kLong, kQuiet));
}

TEST(FileWatch, ManyWritesAreOneSave) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "a.toml";
    FileWatch watch;
    watch.watch({file});
    for (int i = 0; i < 20; ++i) write_file(file, std::to_string(i));
    EXPECT_TRUE(watch.wait(kLong, milliseconds(50)));
    EXPECT_FALSE(watch.wait(milliseconds(50), kQuiet));
}

TEST(FileWatch, AnOtherListReplacesTheFirst) {
    const TemporaryFolder first, second;
    FileWatch watch;
    watch.watch({first.path() / "a"});
    watch.watch({second.path() / "a"});
    write_file(first.path() / "a", "1");
    EXPECT_FALSE(watch.wait(milliseconds(50), kQuiet));
    write_file(second.path() / "a", "1");
    EXPECT_TRUE(watch.wait(kLong, kQuiet));
    EXPECT_THROW(watch.watch({first.path() / "missing" / "a"}), IoError);
}

}  // namespace
}  // namespace fusee::core
