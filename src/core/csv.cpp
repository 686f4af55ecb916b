#include "fusee/core/csv.h"

#include <fmt/format.h>

#include <algorithm>

#include "csv_header.h"
#include "csv_text.h"
#include "fusee/core/file.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"

namespace fusee::core {

namespace {

constexpr std::size_t kLongestLine = 1'000'000;  // bytes: a file with longer lines is not a table
constexpr std::size_t kHead = 300'000;           // bytes whose lines show the form of the table
constexpr std::size_t kQuotedLines = 20;         // that one row may have in quoted cells

}  // namespace

/// One pass over the lines, which may come in pieces; the table grows row by row. The first lines are kept until their form is known.
class CsvParser {
public:
    CsvParser(const std::string& file, const std::vector<CsvColumn>& columns, const CsvOptions& options)
        : known_(columns), options_(options), faults_(file) {
        table_.file_ = file;
        table_.mapping_ = options.mapping;
        names_ = listed(known_, &CsvColumn::in_header, ",");
    }

    /// The next bytes of the file, cut anywhere.
    void take(std::string_view bytes) {
        std::string_view text = decoder_.utf8(bytes);
        if (!begun_) {
            const std::size_t wanted = std::min(text.size(), kHead - head_.size());
            head_.append(text.substr(0, wanted));
            text.remove_prefix(wanted);
            if (head_.size() < kHead) return;
            begin(false);
        }
        take_lines(text);
    }

    CsvTable finish() {
        if (!begun_) begin(true);
        if (!rest_.empty()) read_line(rest_);
        if (!quoted_.empty()) give_up(fault(1, "row", in_quotes(quoted_), "a quote that is closed"));
        faults_.throw_if_any();
        if (table_.rows() < options_.least_rows)
            throw fault(1, "rows", fmt::format("{}", table_.rows()), fmt::format("at least {}", options_.least_rows));
        return std::move(table_);
    }

    /// Has the head a line that names every required column?
    [[nodiscard]] bool fits(std::string_view bytes) {
        head_ = decoder_.utf8(bytes.substr(0, kHead));
        const auto [lines, numbers] = head_lines(bytes.size() < kHead);
        const auto dialect = find_dialect(lines, known_, options_.mapping);
        if (!dialect || !splitter_.split(header_text(lines, *dialect), dialect->separator, cells_)) return false;
        return match_header(cells_, dialect->units, known_, options_.mapping).missing.empty();
    }
    [[nodiscard]] std::vector<std::string> header(std::string_view bytes) {
        std::vector<std::string> cells;
        head_ = decoder_.utf8(bytes.substr(0, kHead));
        const auto [lines, numbers] = head_lines(bytes.size() < kHead);
        if (const auto dialect = find_dialect(lines, known_, options_.mapping);
            dialect && splitter_.split(lines[dialect->header], dialect->separator, cells_))
            for (const CsvCell& cell : cells_) cells.emplace_back(cell.text);
        return cells;
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

    /// The lines of the head, a row in several lines as one, each with its number. Without an end of line the last one may be cut.
    [[nodiscard]] std::pair<std::vector<std::string_view>, std::vector<std::size_t>> head_lines(bool whole) {
        if (head_.find('\n') == std::string::npos) std::replace(head_.begin(), head_.end(), '\r', '\n');
        std::vector<std::string_view> lines;
        std::vector<std::size_t> numbers;
        std::size_t number = 0;
        const std::string_view head = head_;
        for (std::size_t at = 0; at < head.size();) {
            std::size_t end = head.find('\n', at), count = 1;
            if (end == std::string_view::npos && !whole && at > 0) break;
            const auto open = [&] {
                const std::string_view line = head.substr(at, std::min(end, head.size()) - at);
                return std::count(line.begin(), line.end(), '"') % 2 == 1;
            };
            for (std::size_t longer = end; count < kQuotedLines && longer != std::string_view::npos && open(); ++count)
                end = longer = head.find('\n', longer + 1);
            if (open()) end = head.find('\n', at), count = 1;
            std::string_view line = head.substr(at, std::min(end, head.size()) - at);
            if (line.ends_with('\r')) line.remove_suffix(1);
            lines.push_back(line);
            numbers.push_back(number + 1);
            number += count;
            at = end == std::string_view::npos ? head.size() : end + 1;
        }
        return {std::move(lines), std::move(numbers)};
    }

    [[nodiscard]] static std::string_view header_text(const std::vector<std::string_view>& lines, const Dialect& dialect) {
        const std::string_view line = lines[dialect.header];
        return dialect.in_comment ? behind_comment_sign(line) : line;
    }

    /// Recognises the form of the table, then reads the head's rows.
    void begin(bool whole) {
        begun_ = true;
        mac_ = head_.find('\n') == std::string::npos && head_.find('\r') != std::string::npos;
        {
            const auto [lines, numbers] = head_lines(whole);
            const auto dialect = find_dialect(lines, known_, options_.mapping);
            if (!dialect) give_up(fault_at(table_.file_, 1, 1, "header", "(missing)", in_quotes(names_)));
            dialect_ = *dialect;
            line_ = numbers[dialect_.header];
            read_header(header_text(lines, dialect_));
            first_row_ = dialect_.rows < numbers.size() ? numbers[dialect_.rows] : std::numeric_limits<std::size_t>::max();
            if (dialect_.rows == numbers.size()) first_row_ = line_ + (dialect_.rows - dialect_.header);
            find_decimal(lines, numbers);
        }
        const std::string head = std::move(head_);
        take_lines(head);
    }

    void find_decimal(const std::vector<std::string_view>& lines, const std::vector<std::size_t>& numbers) {
        decimal_ = options_.mapping.decimal;
        if (decimal_ != 0) return;
        DecimalMark mark;
        for (std::size_t i = dialect_.rows; i < lines.size(); ++i) {
            if (says_nothing(lines[i]) || !splitter_.split(lines[i], dialect_.separator, cells_)) continue;
            for (const CsvTable::Column& column : table_.columns_)
                if (column.known.kind == CsvColumn::Kind::kNumber && column.cell < cells_.size())
                    mark.add(column.cell, cells_[column.cell].text, numbers[i], cells_[column.cell].place);
        }
        const DecimalMark::Verdict verdict = mark.verdict(dialect_.separator != Separator::kSemicolon);
        decimal_ = verdict.decimal;
        if (verdict.value.empty()) return;
        const auto asked = std::find_if(table_.columns_.begin(), table_.columns_.end(),
                                        [&](const CsvTable::Column& column) { return column.cell == verdict.column; });
        line_ = verdict.line;
        give_up(fault(verdict.place, asked->header, verdict.value,
                      verdict.mixed ? "one decimal mark in the file"
                                    : fmt::format("say which is the decimal mark: {} or {}", options_.mapping.lines({{"decimal", ","}}),
                                                  options_.mapping.lines({{"decimal", "."}}))));
    }

    void take_lines(std::string_view bytes) {
        std::string other;
        if (mac_) {
            other = bytes;
            std::replace(other.begin(), other.end(), '\r', '\n');
            bytes = other;
        }
        while (!bytes.empty()) {
            const std::size_t end = bytes.find('\n');
            if (rest_.size() + std::min(end, bytes.size()) > kLongestLine)
                give_up(fault_at(table_.file_, lines_read_ + 1, 1, "line", "longer", fmt::format("at most {} bytes", kLongestLine)));
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

    void read_line(std::string_view text) {
        ++lines_read_;
        if (lines_read_ < first_row_) return;
        if (text.ends_with('\r')) text.remove_suffix(1);
        if (quoted_.empty()) {
            line_ = lines_read_;
            if (says_nothing(text)) return;
            if (splitter_.split(text, dialect_.separator, cells_)) return read_row(text);
            quoted_ = text;
            return;
        }
        quoted_.append("\n").append(text);
        if (splitter_.split(quoted_, dialect_.separator, cells_)) {
            read_row(quoted_);
            quoted_.clear();
        } else if (lines_read_ - line_ >= kQuotedLines || quoted_.size() > kLongestLine) {
            give_up(fault(1, "row", in_quotes(quoted_), "a quote that is closed"));
        }
    }

    void read_header(std::string_view text) {
        if (!splitter_.split(text, dialect_.separator, cells_)) give_up(fault(1, "header", in_quotes(text), "a quote that is closed"));
        const auto is_number = [](const CsvCell& cell) { return parse_number(cell.text, '.') || parse_number(cell.text, ','); };
        if (std::all_of(cells_.begin(), cells_.end(), is_number))
            give_up(fault(1, "header", "no names", fmt::format("a line with {} above the numbers", in_quotes(names_))));
        if (const std::string name = unknown_name(known_, options_.mapping); !name.empty())
            faults_.add(InvalidInput("--columns", in_quotes(name), "a column of " + table_.file_ + ": " + in_quotes(names_)));
        const HeaderMatch match = match_header(cells_, dialect_.units, known_, options_.mapping);
        std::vector<bool> used(cells_.size(), false);
        for (const FoundColumn& found : match.columns) used[found.cell] = true;
        for (const HeaderFault& f : match.faults) used[f.cell] = true;
        bool repeated = false;  // report once: a file that is not a table has thousands
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            const CsvCell& cell = cells_[i];
            const auto end = cells_.begin() + static_cast<std::ptrdiff_t>(i);
            const auto same = std::find_if(cells_.begin(), end, [&cell](const auto& other) { return other.text == cell.text; });
            const bool matters = same != end && used[static_cast<std::size_t>(same - cells_.begin())];
            if (!cell.text.empty() && matters && !std::exchange(repeated, true))
                faults_.add(fault(cell.place, "header", in_quotes(cell.text), "every column once"));
        }
        for (const HeaderFault& f : match.faults) faults_.add(fault(cells_[f.cell].place, "header", f.value, f.allowed));
        const std::string missing = listed(
            match.missing, [&](std::size_t k) { return known_[k].in_header(); }, ",");
        if (!missing.empty())
            faults_.add(fault(text.size() + 1, "header", in_quotes(missing) + " (missing)",
                              in_quotes(names_) + mapping_to_write(match, cells_, dialect_.units, known_, options_.mapping)));
        faults_.throw_if_any();  // without its columns no row can be read
        for (const FoundColumn& found : match.columns) {
            const CsvColumn& known = known_[found.known];
            if (known.name == options_.span_column) span_column_ = table_.columns_.size();
            numbers_ += known.kind == CsvColumn::Kind::kNumber ? 1 : 0;
            table_.columns_.push_back({known,
                                       found.cell,
                                       std::string(cells_[found.cell].text),
                                       found.told,
                                       found.unit,
                                       found.numerator,
                                       found.denominator,
                                       {},
                                       {},
                                       {}});
        }
        width_ = cells_.size();
    }

    void read_row(std::string_view text) {
        if (table_.rows_read_ >= options_.most_rows) give_up(fault(1, "rows", "more", fmt::format("at most {}", options_.most_rows)));
        const std::size_t before = faults_.count();
        while (cells_.size() > width_ && cells_.back().text.empty()) cells_.pop_back();
        if (cells_.size() > width_) {
            const bool commas = dialect_.separator == Separator::kComma && cells_.size() == width_ + numbers_;
            faults_.add(
                fault(cells_[width_].place, "row", in_quotes(cells_[width_].text),
                      count_of_columns(width_) + (commas ? "; with decimal commas the cells need semicolons, tabs or quotes" : "")));
        }
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
                    column.known.kind == CsvColumn::Kind::kText ? require_words(cell, column.header) : void(value = number(cell, column));
                });
            reported = reported || (lacking && !column.known.gaps);
            values_.push_back(value);
        }
    }

    /// True if the row in `values_` is beyond the longest span.
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

    [[nodiscard]] double number(const CsvCell& cell, const CsvTable::Column& column) const {
        if (column.known.gaps && is_gap(cell.text)) return std::numeric_limits<double>::quiet_NaN();
        if (cell.text.empty()) throw fault(cell.place, column.header, "(missing)", "a finite number in every row");
        const auto value = parse_number(cell.text, decimal_);
        if (!value)
            throw fault(cell.place, column.header, in_quotes(cell.text),
                        fmt::format("a finite number with a decimal {}", decimal_ == ',' ? "comma" : "point"));
        return column.numerator == column.denominator ? *value : *value * column.numerator / column.denominator;
    }

    /// Empty, or what programs write for no number.
    [[nodiscard]] static bool is_gap(std::string_view text) {
        if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
        constexpr std::size_t kLongest = 8;  // "infinity"
        if (text.size() > kLongest) return false;
        const std::string word = lower(text);
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
    TextDecoder decoder_;
    CellSplitter splitter_;
    Dialect dialect_;
    char decimal_ = '.';
    std::vector<CsvCell> cells_;
    std::vector<double> values_;  // of the known columns' numbers in the row, 0 for texts
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    std::size_t span_column_ = kNone;  // its index among the known columns
    double span_start_ = 0.0;
    std::string head_, rest_, quoted_;  // first bytes; of an incomplete line; of a row whose quote is open
    std::size_t lines_read_ = 0, first_row_ = 0;
    std::size_t line_ = 0, width_ = 0, numbers_ = 0;  // line of the row; cells of the header; known columns of numbers
    bool begun_ = false, mac_ = false;                // mac: lines end with CR
};

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

bool csv_fits(std::string_view bytes, const std::vector<CsvColumn>& columns, const CsvMapping& mapping) {
    CsvOptions options;
    options.mapping = mapping;
    return CsvParser("", columns, options).fits(bytes);
}

std::vector<std::string> csv_header(std::string_view bytes) {
    const std::vector<CsvColumn> none;
    const CsvOptions options;
    return CsvParser("", none, options).header(bytes);
}

}  // namespace fusee::core
