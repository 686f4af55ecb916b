#pragma once
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "fusee/core/folder.h"

/// The results of a study on disk: one row for each design (docs/guides/batch.md, "What is on disk").
/// The index of a study: the same bytes from the same rows, whatever the order in which they were made.
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

/// Ends with the SHA-256 of what stands before it: the same row has the same line, byte for byte.
[[nodiscard]] std::string to_json_line(const Row& row);
/// @throws core::InvalidInput naming `place` unless it is a line of to_json_line without its line end
[[nodiscard]] Row parse_row(const std::string& line, const std::string& place);

/// The finished rows of one study: STUDY/rows/*.jsonl, one new file for each process that makes designs: no file that exists is written to.
/// A row is appended with one write and flushed to the disk.
class RowLog {
public:
    /// Makes no file before the first row. @param shard "1-of-4": the file is 1-of-4.jsonl, or 1-of-4.2.jsonl, ...
    /// @throws core::IoError, also if such a name is a link, a folder or a pipe
    RowLog(const core::OutputFolder& study, std::string shard);
    ~RowLog();
    RowLog(const RowLog&) = delete;
    RowLog& operator=(const RowLog&) = delete;

    /// Thread-safe. @throws core::IoError, e.g. if the disk is full
    void append(const Row& row);

private:
    void create();

    std::unique_ptr<core::OpenFolder> study_;
    std::string shard_, name_;
    std::unique_ptr<core::Descriptor> file_;  // none before the first row
    std::mutex mutex_;
};

/// The lines of logs that are not taken.
struct BadRows {
    static constexpr std::size_t kShown = 20;
    std::size_t count = 0;
    std::vector<std::string> first;  ///< "rows/1-of-1.jsonl:17: why", at most kShown

    void add(std::string place_and_why);
};

/// What is wrong with the figures of a row; empty: nothing.
using RowFault = std::function<std::string(const Row&)>;

/// Where the rows of a study stand. Holds about 120 bytes a row, not the rows.
class RowIndex {
public:
    struct Place {
        std::uint32_t file = 0, length = 0;  ///< bytes of the line
        std::uint64_t offset = 0, line = 0;  ///< line: from 1
        std::uint64_t figures = 0;           ///< hash
        bool operator==(const Place&) const = default;
    };

    /// Reads all logs of the study's folder, if there are any, and checks each line; what is no row of fusee's is left out (`bad`).
    /// If a design has two rows, the first counts. @param fault may be empty
    /// @throws core::IoError if a log cannot be read; core::Stopped
    explicit RowIndex(const core::OutputFolder& study, const RowFault& fault = {});
    ~RowIndex();

    [[nodiscard]] std::optional<Place> find(const std::string& key, const std::string& name) const;
    [[nodiscard]] std::size_t size() const { return places_.size(); }
    [[nodiscard]] const BadRows& bad() const { return bad_; }
    [[nodiscard]] const std::vector<std::string>& logs() const { return files_; }  ///< names, sorted
    /// @throws core::IoError; core::InvalidInput if the line is another one now
    [[nodiscard]] Row read(const Place& place) const;
    [[nodiscard]] std::string named(const Place& place) const;  ///< "out/study/rows/1-of-1.jsonl:17"
    /// Calls `take` with each place, in no order.
    void each(const std::function<void(const Place&)>& take) const;

private:
    void scan(std::uint32_t file, const RowFault& fault);
    void index_row(const std::string& line, Place place, const RowFault& fault);

    std::unique_ptr<core::OpenFolder> folder_;  // none: no logs
    std::vector<std::string> files_;
    std::map<std::array<std::uint64_t, 2>, Place> places_;  ///< by a hash of key and name
    BadRows bad_;
};

/// A column of the index.
struct Column {
    std::string name;     ///< letters, digits and '_': a name in SQL
    std::string meaning;  ///< one line, with its unit
    bool is_text = false;
};

/// The rows in the order of the designs; called once for each file that is written.
using EachRow = std::function<void(const std::function<void(const Row&)>&)>;

/// A header and one line for each design; a figure that is not known is an empty cell. @throws core::IoError
void write_csv(const std::filesystem::path& file, const std::vector<Column>& columns, const EachRow& rows);

/// SQLite: table designs (number, name and the columns), table columns (name, meaning). A figure that is not known is NULL.
/// @throws core::IoError
void write_sqlite(const std::filesystem::path& file, const std::vector<Column>& columns, const EachRow& rows);

/// Runs one SQL statement on an index, read-only, and passes the header and each row as texts until `take` returns false. The file may be
/// anybody's: only its tables are read, no view and no other file.
/// @throws core::IoError if the file is not an index; core::InvalidInput for a statement that is wrong, writes or runs longer than `most`;
/// core::Stopped
void query(const std::filesystem::path& file, const std::string& sql, std::chrono::seconds most,
           const std::function<bool(const std::vector<std::string>&)>& take);

/// A key of a profile as a column's name: "cable.diameter_mm" is cable_diameter_mm.
[[nodiscard]] std::string column_name(const std::string& key);

}  // namespace fusee::study
