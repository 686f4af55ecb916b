#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "fusee/core/file.h"
#include "fusee/core/folder.h"

/// Profiles to change by key, and folders that go when a test ends.
namespace fusee::fixtures {

namespace fs = std::filesystem;

class TempFolder : public testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (fs::temp_directory_path() / "fusee-XXXXXX").string();
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
    }
    void TearDown() override { fs::remove_all(folder_); }
    /// Writes a profile and returns its path.
    fs::path write(const std::string& file, const std::string& text) const {
        fs::create_directories((folder_ / file).parent_path());
        core::write_file(folder_ / file, text);
        return folder_ / file;
    }
    /// Copies the tables that shipped profiles name next to the profiles that a test writes.
    void lay_tables() const {
        fs::create_directories(folder_ / "paper");
        for (const char* table : {"measured_table.csv", "paper/table_1.csv"})
            fs::copy_file(fs::path(FUSEE_SOURCE_DIR) / "profiles" / table, folder_ / table, fs::copy_options::overwrite_existing);
    }

    fs::path folder_;
};

inline fs::path shipped(const std::string& name) { return fs::path(FUSEE_SOURCE_DIR) / "profiles" / (name + ".toml"); }

/// The profile with one key set: "k_se.spring.preload_rad", "3.5" as TOML. The key's line is replaced, or begun under its table's heading.
inline std::string with_key(const std::string& text, const std::string& key, const std::string& value) {
    const std::size_t dot = key.rfind('.');
    const std::string table = dot == std::string::npos ? "" : key.substr(0, dot),
                      leaf = dot == std::string::npos ? key : key.substr(dot + 1);
    std::string result, current;
    bool done = false;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        at = end + 1;
        if (line.starts_with('[')) current = line.substr(1, line.find(']') - 1);
        if (!done && current == table && line.starts_with(leaf) && line.find_first_of(" =", leaf.size()) == leaf.size()) {
            result += leaf + " = " + value + "\n";
            done = true;
        } else {
            result += line + "\n";
        }
    }
    if (done) return result;
    const std::string heading = "[" + table + "]";
    const std::size_t place = result.find(heading);
    if (place == std::string::npos) return result + "\n" + heading + "\n" + leaf + " = " + value + "\n";
    return result.insert(result.find('\n', place) + 1, leaf + " = " + value + "\n");
}

/// Keys and their values as TOML.
using Changes = std::vector<std::pair<std::string, std::string>>;

inline std::string with_keys(std::string text, const Changes& changes) {
    for (const auto& [key, value] : changes) text = with_key(text, key, value);
    return text;
}

/// Every file under a folder with its bytes, by name; without the manifests, which name the source relative to the folder.
inline std::map<std::string, std::string> contents(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().filename() != core::kManifestName)
            files[fs::relative(entry.path(), folder).string()] = core::read_file(entry.path());
    return files;
}

}  // namespace fusee::fixtures
