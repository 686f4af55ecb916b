#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/pipeline/make.h"

namespace fusee::batch {

enum class Outcome {
    kMade,
    kRefused,      ///< an impossible design: `result.findings` name the binding limits
    kBadInput,     ///< `error` says what, where and what is allowed
    kFailed,       ///< anything else that went wrong inside: `error`
    kInterrupted,  ///< not begun: the user asked to stop
};
[[nodiscard]] const char* to_string(Outcome outcome);

/// One row of the closing table.
struct Row {
    std::filesystem::path profile;
    Outcome outcome = Outcome::kInterrupted;
    pipeline::MakeResult result;
    std::string error;
    double seconds = 0.0;
};

/// Files as given, whether they exist or not (a missing one becomes a row); a folder stands for its *.toml files, by name.
/// @throws IoError if a folder holds none or cannot be read
[[nodiscard]] std::vector<std::filesystem::path> find_profiles(const std::vector<std::filesystem::path>& paths);

/// Makes every profile on its own, `jobs` at a time (0: one for each processor); one failure is one row. Rows come in the profiles' order,
/// whatever the number of jobs. Ctrl-C lets what is begun finish and begins nothing new. Shows progress when there is more than one. Two
/// profiles with one name would write one folder: the later one is a kBadInput row.
[[nodiscard]] std::vector<Row> make_all(const std::vector<std::filesystem::path>& profiles, const pipeline::MakeOptions& options,
                                        unsigned jobs);

/// 0 all made, 1 a design refused, 2 bad input, 3 a failure inside, 130 interrupted; the gravest counts.
[[nodiscard]] int exit_code(const std::vector<Row>& rows);

/// The closing table, one line a row, and under it what binds each design that was not made.
[[nodiscard]] std::string closing_table(const std::vector<Row>& rows);

}  // namespace fusee::batch
