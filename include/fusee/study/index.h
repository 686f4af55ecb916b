#pragma once
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fusee/study/store.h"

/// The index of a study: the same bytes from the same rows, whatever the order in which they were made.
namespace fusee::study {

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
