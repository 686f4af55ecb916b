#pragma once
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace fusee::fixtures {

/// The files below `folder` of the sources that belong to fusee, relative to the sources: those that git tracks, so that a user's own
/// profile beside them fails no test. Without git or its checkout: all files.
inline std::vector<std::filesystem::path> shipped_files(const std::string& folder) {
    namespace fs = std::filesystem;
    const fs::path source = FUSEE_SOURCE_DIR;
    std::vector<fs::path> files;
    const std::string command = "git -c safe.directory='*' -C '" + source.string() + "' ls-files -- '" + folder + "' 2>/dev/null";
    if (const std::unique_ptr<FILE, int (*)(FILE*)> git(::popen(command.c_str(), "r"), ::pclose); git != nullptr) {
        std::array<char, 4096> line{};
        while (std::fgets(line.data(), line.size(), git.get()) != nullptr) {
            std::string name = line.data();
            if (!name.empty() && name.back() == '\n') name.pop_back();
            if (fs::exists(source / name)) files.emplace_back(name);
        }
    }
    if (files.empty())
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(source / folder))
            if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), source));
    return files;
}

/// Copies them to `to`/FOLDER.
inline void copy_shipped(const std::string& folder, const std::filesystem::path& to) {
    namespace fs = std::filesystem;
    for (const fs::path& file : shipped_files(folder)) {
        fs::create_directories((to / file).parent_path());
        fs::copy_file(fs::path(FUSEE_SOURCE_DIR) / file, to / file, fs::copy_options::overwrite_existing);
    }
}

}  // namespace fusee::fixtures
