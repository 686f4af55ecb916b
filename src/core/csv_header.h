#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "csv_text.h"
#include "fusee/core/csv.h"

/// Which line of a table is its header, what stands between its cells, and which cell is which column.
namespace fusee::core {

/// A known column in the header line.
struct FoundColumn {
    std::size_t known = 0, cell = 0;  ///< indices
    double numerator = 1.0, denominator = 1.0;
    std::optional<std::size_t> unit = {};  ///< index in CsvColumn::units
    bool told = false;                     ///< the user's mapping gives the unit
};
/// A fault of a header cell.
struct HeaderFault {
    std::size_t cell = 0;
    std::string value, allowed;
};

/// How one header line names the known columns.
struct HeaderMatch {
    std::vector<FoundColumn> columns;
    std::vector<HeaderFault> faults;   ///< a question, an unknown unit
    std::vector<std::size_t> missing;  ///< known columns that are required
};
/// @param units of each cell, from a row of units; may be shorter
[[nodiscard]] HeaderMatch match_header(const std::vector<CsvCell>& cells, const std::vector<std::string>& units,
                                       const std::vector<CsvColumn>& known, const CsvMapping& mapping);
/// The first name of --columns that is no known column; "": none. A table of a TOML file may speak of several files.
[[nodiscard]] std::string unknown_name(const std::vector<CsvColumn>& known, const CsvMapping& mapping);
/// The missing columns with the lines of a mapping to write, where cells of the header could be them.
[[nodiscard]] std::string mapping_to_write(const HeaderMatch& match, const std::vector<CsvCell>& cells,
                                           const std::vector<std::string>& units, const std::vector<CsvColumn>& known,
                                           const CsvMapping& mapping);

/// The form of a table, from its first lines.
struct Dialect {
    Separator separator = Separator::kComma;
    std::size_t header = 0;          ///< index of its line
    bool in_comment = false;         ///< the header stands behind a comment sign
    std::vector<std::string> units;  ///< of each cell, from a row of units
    std::size_t rows = 0;            ///< index of the first line that may be a row
};
/// @returns none where no line is more than a comment
[[nodiscard]] std::optional<Dialect> find_dialect(const std::vector<std::string_view>& lines, const std::vector<CsvColumn>& known,
                                                  const CsvMapping& mapping);

/// "three columns".
[[nodiscard]] std::string count_of_columns(std::size_t count);

}  // namespace fusee::core
