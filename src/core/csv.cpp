#include "fusee/core/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include "fusee/core/file.h"
#include "fusee/core/text.h"

namespace fusee::core {

struct CsvCell {
    std::string_view text;
    std::size_t place;  // of its first character, from 1
};

namespace {

constexpr std::size_t kShown = 60;               // characters of a wrong cell in a message
constexpr std::size_t kMostFaults = 20;          // that are reported one by one
constexpr std::size_t kLongestLine = 1'000'000;  // bytes: a file with longer lines is not a table

void split(std::string_view line, std::vector<CsvCell>& cells) {
    cells.clear();
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(',', begin), line.size());
        std::size_t first = begin, last = end;
        while (first < last && (line[first] == ' ' || line[first] == '\t')) ++first;
        while (last > first && (line[last - 1] == ' ' || line[last - 1] == '\t')) --last;
        cells.push_back({line.substr(first, last - first), first + 1});
        begin = end + 1;
    }
}

std::string in_quotes(std::string_view text) { return fmt::format("'{}'", printable(text, kShown)); }

std::string count_of_columns(std::size_t count) {
    constexpr std::array<const char*, 10> kWords{"no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine"};
    return fmt::format("{} column{}", count < kWords.size() ? kWords[count] : fmt::format("{}", count), count == 1 ? "" : "s");
}

InvalidInput fault_at(const std::string& file, std::size_t line, std::size_t place, std::string_view what, std::string value,
                      std::string allowed) {
    return {fmt::format("{}:{}:{}: {}", file, line, place, what), std::move(value), std::move(allowed)};
}

}  // namespace

void CsvFaults::add(InvalidInput fault) {
    if (count_++ < kMostFaults) first_.add(std::move(fault));
}

void CsvFaults::throw_if_any() const {
    Mistakes all = first_;
    if (count_ > kMostFaults) all.add(InvalidInput(file_, fmt::format("and {} more", count_ - kMostFaults), "none"));
    all.throw_if_any();
}

/// One pass over the lines, which may come in pieces; the table grows row by row.
class CsvParser {
public:
    CsvParser(const std::string& file, const std::vector<CsvColumn>& columns, const CsvOptions& options)
        : known_(columns), options_(options), faults_(file) {
        table_.file_ = file;
        for (const CsvColumn& column : known_) names_ += (names_.empty() ? "" : ",") + column.in_header();
    }

    /// The next bytes of the file, cut anywhere.
    void take(std::string_view bytes) {
        while (!bytes.empty()) {
            const std::size_t end = bytes.find('\n');
            if (rest_.size() + std::min(end, bytes.size()) > kLongestLine)
                give_up(fault_at(table_.file_, line_ + 1, 1, "line", "longer", fmt::format("at most {} bytes", kLongestLine)));
            if (end == std::string_view::npos) {
                rest_.append(bytes);
                return;
            }
            if (rest_.empty()) {
                read_line(bytes.substr(0, end));
            } else {
                read_line(rest_.append(bytes.substr(0, end)));
                rest_.clear();
            }
            bytes.remove_prefix(end + 1);
        }
    }

    CsvTable finish() {
        if (!rest_.empty()) read_line(rest_);
        if (!headed_) give_up(fault_at(table_.file_, 1, 1, "header", "(missing)", in_quotes(names_)));
        faults_.throw_if_any();
        if (table_.rows() < options_.least_rows)
            throw fault(1, "rows", fmt::format("{}", table_.rows()), fmt::format("at least {}", options_.least_rows));
        return std::move(table_);
    }

private:
    /// A fault after which reading cannot continue.
    [[noreturn]] void give_up(InvalidInput fault) {
        faults_.add(fault);
        faults_.throw_if_any();
        throw fault;
    }
    [[nodiscard]] InvalidInput fault(std::size_t place, std::string_view what, std::string value, std::string allowed) const {
        return fault_at(table_.file_, line_, place, what, std::move(value), std::move(allowed));
    }

    void read_line(std::string_view text) {
        if (line_++ == 0 && text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
        if (text.ends_with('\r')) text.remove_suffix(1);
        if (text.find_first_not_of(" \t") == std::string_view::npos || text.starts_with('#')) return;
        split(text, cells_);
        headed_ ? read_row(text) : read_header(text);
        headed_ = true;
    }

    void read_header(std::string_view text) {
        bool repeated = false;  // report once: a file that is not a table has thousands
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            const CsvCell& cell = cells_[i];
            const auto same = [&cell](const auto& other) { return other.text == cell.text; };
            const auto end = cells_.begin() + static_cast<std::ptrdiff_t>(i);
            if (!cell.text.empty() && std::find_if(cells_.begin(), end, same) != end && !std::exchange(repeated, true))
                faults_.add(fault(cell.place, "header", in_quotes(cell.text), "every column once"));
            const auto known =
                std::find_if(known_.begin(), known_.end(), [&cell](const CsvColumn& c) { return c.in_header() == cell.text; });
            if (known != known_.end()) {
                if (known->name == options_.span_column) span_column_ = table_.columns_.size();
                table_.columns_.push_back({*known, i, {}, {}, {}});
            }
            if (known == known_.end() && !options_.extra_columns)
                faults_.add(fault(cell.place, "header", in_quotes(cell.text), in_quotes(names_)));
        }
        std::string missing;
        for (const CsvColumn& column : known_)
            if (column.required && !table_.has(column.name)) missing += (missing.empty() ? "" : ",") + column.in_header();
        if (!missing.empty()) faults_.add(fault(text.size() + 1, "header", in_quotes(missing) + " (missing)", in_quotes(names_)));
        faults_.throw_if_any();  // without its columns no row can be read
        width_ = cells_.size();
    }

    void read_row(std::string_view text) {
        if (table_.rows_read_ >= options_.most_rows) give_up(fault(1, "rows", "more", fmt::format("at most {}", options_.most_rows)));
        const std::size_t before = faults_.count();
        if (cells_.size() > width_)
            faults_.add(fault(cells_[width_].place, "row", in_quotes(cells_[width_].text), count_of_columns(width_)));
        read_cells(text);
        const bool beyond = is_beyond();
        table_.rows_beyond_ += beyond ? 1 : 0;
        if (table_.rows() >= options_.most_kept && table_.rows_read_ % table_.stride_ == 0 && !beyond) thin();
        if (table_.rows_read_++ % table_.stride_ == 0 && !beyond && faults_.count() == before) keep_row();
    }

    /// Reads the row's numbers into `values_`. Of a short row only the first missing cell is reported.
    void read_cells(std::string_view text) {
        values_.clear();
        const std::size_t given = cells_.size();
        bool reported = false;
        for (const CsvTable::Column& column : table_.columns_) {
            const bool lacking = column.cell >= given;
            if (lacking) cells_.resize(std::max(cells_.size(), column.cell + 1), CsvCell{{}, text.size() + 1});
            const CsvCell& cell = cells_[column.cell];
            double value = 0.0;
            if (!lacking || !reported)
                faults_.collect([&] {
                    column.known.kind == CsvColumn::Kind::kText ? require_words(cell, column.known.in_header())
                                                                : void(value = number(cell, column.known));
                });
            reported = reported || (lacking && !column.known.gaps);
            values_.push_back(value);
        }
    }

    /// Of the row in `values_`.
    [[nodiscard]] bool is_beyond() {
        if (span_column_ == kNone) return false;
        if (table_.rows_read_ == 0) span_start_ = values_[span_column_];
        return values_[span_column_] - span_start_ > options_.longest_span;
    }

    void keep_row() {
        for (std::size_t i = 0; i < table_.columns_.size(); ++i) {
            CsvTable::Column& column = table_.columns_[i];
            const CsvCell& cell = cells_[column.cell];
            if (column.known.kind == CsvColumn::Kind::kText)
                column.texts.emplace_back(cell.text);
            else
                column.numbers.push_back(values_[i]);
            column.places.push_back(static_cast<std::uint32_t>(cell.place));
        }
        table_.lines_.push_back(static_cast<std::uint32_t>(line_));
    }

    /// Keeps every second of the rows kept so far, and of those to come.
    void thin() {
        const auto halve = [](auto& cells) {
            for (std::size_t i = 2; i < cells.size(); i += 2) cells[i / 2] = std::move(cells[i]);
            cells.resize((cells.size() + 1) / 2);
        };
        halve(table_.lines_);
        for (CsvTable::Column& column : table_.columns_) {
            halve(column.numbers);
            halve(column.texts);
            halve(column.places);
        }
        table_.stride_ *= 2;
    }

    [[nodiscard]] double number(const CsvCell& cell, const CsvColumn& column) const {
        const std::string& name = column.in_header();
        if (column.gaps && is_gap(cell.text)) return std::numeric_limits<double>::quiet_NaN();
        if (cell.text.empty()) throw fault(cell.place, name, "(missing)", "a finite number in every row");
        std::string_view digits = cell.text;
        if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
        double value = 0.0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value))
            throw fault(cell.place, name, in_quotes(cell.text), "a finite number with a decimal point");
        return value;
    }

    /// Empty, or what programs write for no number.
    [[nodiscard]] static bool is_gap(std::string_view text) {
        if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
        constexpr std::size_t kLongest = 8;  // "infinity"
        if (text.size() > kLongest) return false;
        std::string word(text);
        std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        return word.empty() || word == "nan" || word == "inf" || word == "infinity";
    }

    void require_words(const CsvCell& cell, const std::string& name) const {
        if (cell.text.empty()) throw fault(cell.place, name, "(missing)", "a text in every row");
        if (cell.text.find('"') != std::string_view::npos)
            throw fault(cell.place, name, in_quotes(cell.text), "a text without quotation marks");
    }

    const std::vector<CsvColumn>& known_;
    const CsvOptions& options_;
    CsvTable table_;
    CsvFaults faults_;
    std::string names_;  // of the known columns, as a header line
    std::vector<CsvCell> cells_;
    std::vector<double> values_;  // of the known columns' numbers in the row, 0 for texts
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::size_t span_column_ = kNone;  // its index among the known columns
    double span_start_ = 0.0;
    std::string rest_;  // of an incomplete line
    std::size_t line_ = 0, width_ = 0;
    bool headed_ = false;
};

bool CsvTable::has(std::string_view name) const {
    return std::any_of(columns_.begin(), columns_.end(), [name](const Column& c) { return c.known.name == name; });
}

const CsvTable::Column& CsvTable::column(std::string_view name) const {
    const auto found = std::find_if(columns_.begin(), columns_.end(), [name](const Column& c) { return c.known.name == name; });
    assert(found != columns_.end());
    return *found;
}

const std::vector<double>& CsvTable::numbers(std::string_view name) const {
    assert(column(name).known.kind == CsvColumn::Kind::kNumber);
    return column(name).numbers;
}

const std::vector<std::string>& CsvTable::texts(std::string_view name) const {
    assert(column(name).known.kind == CsvColumn::Kind::kText);
    return column(name).texts;
}

InvalidInput CsvTable::fault(std::size_t row, std::string_view name, std::string value, std::string allowed) const {
    const Column& faulty = column(name);
    return fault_at(file_, lines_.at(row), faulty.places.at(row), faulty.known.in_header(), std::move(value), std::move(allowed));
}

CsvTable parse_csv(std::string_view bytes, const std::string& file, const std::vector<CsvColumn>& columns, const CsvOptions& options) {
    CsvParser parser(file, columns, options);
    parser.take(bytes);
    return parser.finish();
}

CsvTable read_csv(const std::filesystem::path& path, const std::vector<CsvColumn>& columns, const CsvOptions& options,
                  const std::function<void(std::string_view)>& seen) {
    CsvParser parser(path.string(), columns, options);
    read_pieces(path, options.largest_bytes, [&](std::string_view piece) {
        seen(piece);
        parser.take(piece);
    });
    return parser.finish();
}

std::string csv_cell(std::string_view text) {
    // A spreadsheet takes these for a formula, which may start programs; the apostrophe makes it a text there.
    double number = 0.0;
    const char* const end = text.data() + text.size();
    const std::size_t sign = !text.empty() && text.front() == '+' ? 1 : 0;  // from_chars takes no plus
    const bool is_formula = text.size() > 1 && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos &&
                            std::from_chars(text.data() + sign, end, number).ptr != end;
    if (!is_formula && text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string cell = is_formula ? "\"'" : "\"";
    for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
    return cell + '"';
}

}  // namespace fusee::core
