#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

/// The results of a study on disk: one row for each design (docs/guides/batch.md, "What is on disk").
namespace fusee::study {

/// A number (NaN: not known), or a text.
using Figure = std::variant<double, std::string>;

/// The result of one design.
struct Row {
    std::string key;  ///< SHA-256 of all that determines the result: profile, program's version, options
    std::size_t index = 0;
    std::string name;
    std::vector<std::pair<std::string, Figure>> figures;  ///< columns of the index, in their order
    double seconds = 0.0;                                 ///< of processor and waiting; apart from the index, which is the same every time

    /// nullptr if the row has no figure of this name.
    [[nodiscard]] const Figure* find(std::string_view name) const;
    bool operator==(const Row&) const = default;
};

[[nodiscard]] std::string to_json_line(const Row& row);
/// @throws core::InvalidInput naming `file` if it is not a row
[[nodiscard]] Row parse_row(const std::string& line, const std::string& file);

/// The finished rows of one study: STUDY/rows/*.jsonl, one file for each process that makes designs. A row is appended with one write and
/// flushed to the disk; of a file whose process was killed, an unfinished last line is ignored.
class RowLog {
public:
    /// Opens the log of one process; a further one if another process holds it, e.g. a task that a cluster has given up but that still
    /// runs. @param shard "1-of-4"
    /// @throws core::IoError
    RowLog(const std::filesystem::path& study, const std::string& shard);
    ~RowLog();
    RowLog(const RowLog&) = delete;
    RowLog& operator=(const RowLog&) = delete;

    /// Thread-safe. @throws core::IoError, e.g. if the disk is full
    void append(const Row& row);

private:
    std::filesystem::path path_;
    int file_ = -1;
    std::mutex mutex_;
};

/// Where the rows of a study stand. Holds about 80 bytes a row, not the rows.
class RowIndex {
public:
    struct Place {
        std::uint32_t file = 0;
        std::uint64_t offset = 0;
        bool operator==(const Place&) const = default;
    };

    /// Reads all logs of the study's folder, if there are any; of two rows with one key the first counts. @throws core::IoError
    explicit RowIndex(const std::filesystem::path& study);

    [[nodiscard]] std::optional<Place> find(const std::string& key) const;
    [[nodiscard]] std::size_t size() const { return places_.size(); }
    /// @throws core::IoError; core::InvalidInput if the line is damaged
    [[nodiscard]] Row read(const Place& place) const;

private:
    void scan(std::uint32_t file);

    std::vector<std::filesystem::path> files_;
    std::map<std::array<std::uint64_t, 2>, Place> places_;  ///< by the first 128 bits of the key
};

}  // namespace fusee::study
