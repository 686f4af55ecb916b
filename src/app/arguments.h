#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/core/parallel.h"
#include "numbers.h"

namespace fusee::app {

/// Some libraries abort if no thread can be started; this function reports it first. @throws core::IoError
inline void require_thread() {
    try {
        const std::jthread one([] {});
    } catch (const std::system_error& e) {
        throw core::IoError("ulimit -u", "no thread can be started: " + e.code().message());
    }
}

/// -j, --jobs: 0 to core::kMostWorkers.
inline void add_jobs(CLI::App& command, unsigned& jobs, const std::string& meaning) {
    command.add_option("-j,--jobs", jobs, meaning)->check(number_within(0U, core::kMostWorkers))->capture_default_str();
}

/// --force of a command that writes into a folder (docs/outputs.md).
inline void add_force(CLI::App& command, bool& force) {
    command.add_flag("--force", force, "Also replace files of another source and changed files. Files that fusee did not make always stay");
}

/// --force of a command that writes a file that the user names.
inline void add_force_file(CLI::App& command, bool& force) { command.add_flag("--force", force, "Replace the file if it exists"); }

/// --columns of a command that reads a table: core::CsvMapping::of its values.
inline void add_columns(CLI::App& command, std::vector<std::string>& columns) {
    command
        .add_option(
            "--columns", columns,
            "A column that is not recognised by its header: NAME=HEADER, or 'NAME=HEADER in UNIT', once for each; decimal=, for a decimal "
            "comma")
        ->type_name("NAME=HEADER")
        ->allow_extra_args(false);
}

/// Two sets of files of one run go to two folders: in one folder the later set would replace the earlier.
/// @param allowed completes "a folder other than". @throws core::InvalidInput naming `option`
inline void require_other_folder(const char* option, const std::filesystem::path& folder, const std::filesystem::path& other,
                                 const std::string& allowed) {
    const auto place = [](const std::filesystem::path& path) {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(path) / ".");
    };
    if (place(folder) == place(other)) throw core::InvalidInput(option, folder.string(), "a folder other than " + allowed);
}

}  // namespace fusee::app
