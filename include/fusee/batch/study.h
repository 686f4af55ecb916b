#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/study/store.h"
#include "fusee/study/study.h"

namespace fusee::batch {

/// The share of one process: the designs number - 1, number - 1 + count, number - 1 + 2 count, ...
struct Shard {
    std::size_t number = 1, count = 1;
    /// How many of so many designs are in the share.
    [[nodiscard]] std::size_t size(std::size_t designs) const;
    /// The design at `place` of the share, counted from 0.
    [[nodiscard]] std::size_t index(std::size_t place) const { return number - 1 + place * count; }
};
/// "3/8"; at most study::kMostDesigns shards. @throws core::InvalidInput naming --shard
[[nodiscard]] Shard parse_shard(const std::string& text);

struct StudyOptions {
    std::filesystem::path out = "out";  ///< the study is written to out/NAME
    unsigned jobs = 0;                  ///< designs made at the same time; 0: one for each processor
    Shard shard;                        ///< with more than one the index is written by `write_index`
    bool force = false;                 ///< also replace files of another study in out/NAME, and files changed since
};

/// What became of the designs of a study, or of a shard of it.
struct StudyResult {
    std::filesystem::path folder;  ///< out/NAME
    std::size_t planned = 0;
    std::size_t excluded = 0;  ///< by a constraint
    std::size_t earlier = 0;   ///< finished by an earlier run
    std::size_t made = 0, refused = 0;
    std::size_t bad_input = 0;  ///< made again by the next run
    std::size_t failed = 0;     ///< internal errors; made again by the next run
    std::size_t indexed = 0;    ///< designs in the index; 0: it was not written
    bool interrupted = false;
    study::BadRows bad_rows;           ///< lines of the logs that are not taken
    std::vector<std::string> reasons;  ///< of the first designs with bad input or an internal error: "NAME: reason"
};

/// Makes the designs that have no good row yet, one row for each (study::RowLog); a design that fails is one row, the others go on. Ctrl-C
/// finishes the designs that are being made. Then writes the index, unless the study is sharded or was stopped. Every file is the same for
/// any number of jobs and shards, and after any number of killed runs. Shows progress.
/// @throws core::IoError if out/NAME cannot be written
[[nodiscard]] StudyResult run_study(const study::Plan& plan, const StudyOptions& options);

/// The designs of an index.
struct IndexSize {
    std::size_t designs = 0;
    std::size_t missing = 0;           ///< not finished, or with bad input
    std::vector<std::string> names{};  ///< of the first missing designs
    /// The shards that miss designs, with how many, by the numbers of the logs' names: of `shards`; 0: the study was not sharded.
    std::map<std::size_t, std::size_t> missing_of_shard{};
    std::size_t shards = 0;
    study::BadRows bad_rows{};  ///< lines of the logs that are not taken, or of no design of the study
};
/// Writes index.csv, index.sqlite and index.html of the rows that exist; nothing if there is none.
/// @throws core::IoError
IndexSize write_index(const study::Plan& plan, const std::filesystem::path& out, bool force);

/// What one design takes on the shipped profiles, with about 10,000 triangles a cam (docs/performance.md).
struct Cost {
    double seconds = 0.0;  ///< of one processor
    double bytes = 0.0;
};
[[nodiscard]] Cost usual_cost(study::Outputs outputs);

/// 0 if every design was made or refused or excluded, 2 bad input, 3 internal error, 130 interrupted.
[[nodiscard]] int exit_code(const StudyResult& result);

}  // namespace fusee::batch
