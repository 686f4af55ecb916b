#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fusee/core/error.h"
#include "fusee/core/path.h"

/// CSV tables, and units of measured data as spreadsheets and instruments write them.
namespace fusee::core {

/// SI value = value * numerator / denominator: with integers and powers of ten "0.8 mm" becomes the double nearest to 8e-4.
struct MeasureUnit {
    const char* name;      ///< "mNm", "deg", "N/mm"
    const char* quantity;  ///< "torque": units of one quantity convert into each other
    double numerator = 1.0, denominator = 1.0;
    [[nodiscard]] bool converts_to(const MeasureUnit& other) const { return std::string_view(quantity) == other.quantity; }
    /// @pre converts_to(other)
    [[nodiscard]] double to(const MeasureUnit& other, double value) const {
        return value * (numerator * other.denominator) / (denominator * other.numerator);
    }
};

/// The unit in any spelling: "N·m", "N m", "[Nm]", "°", "degrees", "µm", "N/mm²", "Nm_per_rad"; capitals count only where they tell units
/// apart ("mN" and "MN"). Null: not known.
[[nodiscard]] const MeasureUnit* find_measure_unit(std::string_view text);

/// Every known unit of one quantity, the SI unit first.
[[nodiscard]] std::span<const MeasureUnit> measure_units(std::string_view quantity);

/// "rad, mrad, deg, turn"
[[nodiscard]] std::string measure_unit_names(std::string_view quantity);

/// A column's name in two: "motor_torque_Nm", "Torque [N·m]", "Torque / Nm", "torque in Nm", "angle_deg".
struct Measured {
    std::string stem;                   ///< "motortorque": lower-case letters and figures; other characters stay
    std::string unit_text;              ///< "Nm", as it stands; "": none
    const MeasureUnit* unit = nullptr;  ///< null: none, or not known
};
[[nodiscard]] Measured measured_name(std::string_view name);

/// A column that a reader knows.
struct CsvColumn {
    enum class Kind { kNumber, kText };
    std::string name;  ///< as in the header line, unless `header` is given
    Kind kind = Kind::kNumber;
    bool required = true;     ///< an optional column may be absent as a whole; if present, every row fills it
    bool gaps = false;        ///< of numbers: an empty cell, "nan" and "inf" (any case, any sign) are NaN
    std::string header = {};  ///< other name in the header line, as the user gives it; "": `name`
    /// A number's value is scale * the file's number. Without a scale the unit in the header gives it, if there is one. @pre not 0
    std::optional<double> scale = {};
    /// The units of a number whose name has none, of one quantity each; a header may name any unit of these quantities.
    std::vector<std::string> units = {};
    [[nodiscard]] const std::string& in_header() const { return header.empty() ? name : header; }
};

/// What the user says of a file that its reader cannot know (docs/tables.md).
struct CsvMapping {
    std::map<std::string, std::string>
        columns;             ///< by a column's name: its header in the file, "Winkel", or with its unit, "Winkel in deg"
    char decimal = 0;        ///< '.' or ','; 0: as the numbers show
    std::string table = {};  ///< where a mapping is written: a table of a TOML file; "": the option --columns
    /// @param entries "angle_rad=Winkel in deg", "decimal=,": the values of --columns @throws InvalidInput
    [[nodiscard]] static CsvMapping of(const std::vector<std::string>& entries);
    /// Takes one entry. @param place of it, for messages @throws InvalidInput
    void add(const std::string& name, const std::string& header, const std::string& place);
    /// "--columns 'angle_rad=Winkel in deg'", or as one line of TOML: "columns = { angle_rad = "Winkel in deg" }".
    [[nodiscard]] std::string lines(const std::vector<std::pair<std::string, std::string>>& entries) const;
};

struct CsvOptions {
    std::size_t least_rows = 1;               ///< rows below the header
    std::size_t most_rows = 1'000'000;        ///< about 12 bytes of memory for each number
    std::size_t largest_bytes = 200'000'000;  ///< of the file
    /// If there are more rows, only every 2nd, 4th, 8th, ... is kept, from the first on; the others are checked too.
    std::size_t most_kept = std::numeric_limits<std::size_t>::max();
    /// A column of numbers; rows more than `longest_span` above its first row are checked, but not kept. "": none.
    std::string span_column = {};
    double longest_span = std::numeric_limits<double>::infinity();
    CsvMapping mapping = {};
};

/// The known columns of a CSV file; immutable. Rows count from 0.
class CsvTable {
public:
    [[nodiscard]] std::size_t rows() const { return lines_.size(); }
    /// Rows of the file, kept or not. Every stride()-th is kept.
    [[nodiscard]] std::size_t rows_read() const { return rows_read_; }
    [[nodiscard]] std::size_t rows_beyond_span() const { return rows_beyond_; }
    [[nodiscard]] std::size_t stride() const { return stride_; }
    [[nodiscard]] bool has(std::string_view column) const;
    /// Does the user's mapping give this column's unit? Then a value is not asked about. @pre has(column)
    [[nodiscard]] bool unit_is_told(std::string_view column) const { return this->column(column).told; }
    /// Index in CsvColumn::units of the quantity that the header names; none without a unit. @pre has(column)
    [[nodiscard]] std::optional<std::size_t> unit(std::string_view column) const { return this->column(column).unit; }
    /// The question for a column whose values look like another unit: an error at the row, with the line to write for each answer.
    /// @param asked unit that the values look like @pre has(column), row < rows()
    [[nodiscard]] InvalidInput question(std::size_t row, std::string_view column, std::string_view asked, std::string_view why) const;
    /// @pre has(column), and it is of that kind
    [[nodiscard]] const std::vector<double>& numbers(std::string_view column) const;
    [[nodiscard]] const std::vector<std::string>& texts(std::string_view column) const;
    /// The row's line in the file, from 1.
    [[nodiscard]] std::size_t line(std::size_t row) const { return lines_.at(row); }
    /// An error "file:line:column: name" to throw, for rules that only the caller knows. @pre has(column), row < rows()
    [[nodiscard]] InvalidInput fault(std::size_t row, std::string_view column, std::string value, std::string allowed) const;

private:
    friend class CsvParser;
    struct Column {
        CsvColumn known;
        std::size_t cell = 0;  // its index in the header line
        std::string header;    // its text
        bool told = false;
        std::optional<std::size_t> unit;
        double numerator = 1.0, denominator = 1.0;  // value = number * numerator / denominator
        std::vector<double> numbers;
        std::vector<std::string> texts;
        std::vector<std::uint32_t> places;  // where its cell begins in each line, from 1
    };
    [[nodiscard]] const Column& column(std::string_view name) const;

    std::string file_;
    CsvMapping mapping_;
    std::size_t rows_read_ = 0, rows_beyond_ = 0, stride_ = 1;
    std::vector<std::uint32_t> lines_;  // of each row, from 1
    std::vector<Column> columns_;
};

/// The faults of one table. Reading continues after each, so that all are reported at once; the first 20 are kept, the others counted.
class CsvFaults {
public:
    explicit CsvFaults(std::string file) : file_(std::move(file)) {}
    void add(InvalidInput fault);
    /// Runs `read` and keeps what it throws as InvalidInput.
    template <class Read>
    void collect(const Read& read) {
        try {
            read();
        } catch (const InvalidInput& e) {
            add(e);
        }
    }
    [[nodiscard]] std::size_t count() const { return count_; }
    /// @throws InvalidInput or, of several, InvalidInputs
    void throw_if_any() const;

private:
    std::string file_;
    Mistakes first_;
    std::size_t count_ = 0;
};

/// Reads a header line with the columns' names in any order, then one row per line (docs/tables.md). Recognised are commas, semicolons,
/// tabs, bars or blanks between the cells; quoted cells; a decimal comma; groups of three figures; UTF-8, UTF-16, Windows-1252; a header in
/// other capitals or with its unit, "Torque [mNm]", which is converted; a row of units; lines above the header. A byte order mark, CR LF,
/// spaces around cells, blank lines and comments ('#', '%', "//") are ignored. Numbers are finite; texts are not empty and hold no
/// quotation marks. What fits twice is asked, with the lines of a mapping to write; nothing is guessed.
/// @param file the name used in messages
/// @throws InvalidInput, of several InvalidInputs: "file:line:column: name" for a gap, a text instead of a number, a NaN; "...: header"
/// for a header that lacks a required column, has one twice or, where extra columns are refused, an unknown one; "...: row", "...: rows"
/// for too many cells, too few or too many rows; "...: line" for one of more than a million bytes
[[nodiscard]] CsvTable parse_csv(std::string_view bytes, const std::string& file, const std::vector<CsvColumn>& columns,
                                 const CsvOptions& options = {});
/// The same from a file, which is read in pieces.
/// @param seen gets every byte, in order: for a hash
/// @throws IoError, also when the file is larger than options.largest_bytes
[[nodiscard]] CsvTable read_csv(
    const std::filesystem::path& path, const std::vector<CsvColumn>& columns, const CsvOptions& options = {},
    const std::function<void(std::string_view)>& seen = [](std::string_view) {});

/// Has the file a header with every required column? Reads its beginning only. @throws nothing
[[nodiscard]] bool csv_fits(std::string_view bytes, const std::vector<CsvColumn>& columns, const CsvMapping& mapping = {});

/// The cells of the header line, quotes removed, whatever they name: the first line that is no comment.
[[nodiscard]] std::vector<std::string> csv_header(std::string_view bytes);

/// A cell for a CSV file: quoted where it holds a comma, a quote or a line end (RFC 4180). A text that a spreadsheet would take for a
/// formula (it begins with = + - @, a tab or a carriage return and is no number) gets an apostrophe before it.
[[nodiscard]] std::string csv_cell(std::string_view text);

}  // namespace fusee::core
