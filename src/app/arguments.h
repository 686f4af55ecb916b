#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include "commands.h"
#include "exit_codes.h"
#include "file_kind.h"
#include "fusee/core/error.h"
#include "fusee/core/parallel.h"
#include "numbers.h"
#include "reply.h"

// The one header of this module that every command's file includes.
namespace fusee::app {

/// Some libraries abort if no thread can be started; this function reports it first. @throws core::IoError
inline void require_thread() {
    try {
        const std::jthread one([] {});
    } catch (const std::system_error& e) {
        throw core::IoError("ulimit -u", "no thread can be started: " + e.code().message());
    }
}

/// Adds the command with what its options fill in; `run` gets it when the user calls the command.
template <class Arguments>
auto add_command(CLI::App& app, Action& action, const char* name, int (*run)(Arguments, Reply&)) {
    CLI::App* const command = add_command(app, name);
    const auto arguments = std::make_shared<std::remove_cvref_t<Arguments>>();
    command->callback([=, &action] { action = [=](Reply& reply) { return run(*arguments, reply); }; });
    return std::pair{command, arguments};
}

/// The profile that a command reads.
inline void add_profile(CLI::App& command, std::filesystem::path& profile, const std::string& meaning) {
    command.add_option("profile", profile, meaning)->type_name("FILE.toml")->check(reads_profile())->required();
}

/// The folder of the gap case that a command reads.
inline void add_case(CLI::App& command, std::filesystem::path& folder, const std::string& meaning) {
    command.add_option("case", folder, meaning)->type_name("FOLDER")->check(reads_case())->required();
}

/// -o, --out: a folder, required if it has no default.
inline void add_out(CLI::App& command, std::filesystem::path& folder, const std::string& meaning) {
    command.add_option("-o,--out", folder, meaning)->type_name("FOLDER")->required(folder.empty());
    if (!folder.empty()) command.get_option("--out")->capture_default_str();
}

/// --catalogue: springs on sale.
inline void add_catalogue(CLI::App& command, std::filesystem::path& file, const std::string& meaning) {
    command.add_option("--catalogue", file, meaning)->type_name("FILE.csv")->check(reads_catalogue());
}

/// An option with a default, a number from `low` to `high`.
template <class Number>
void add_number(CLI::App& command, const char* option, Number& number, std::type_identity_t<Number> low, std::type_identity_t<Number> high,
                const std::string& meaning) {
    command.add_option(option, number, meaning)->check(number_within(low, high))->capture_default_str();
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
