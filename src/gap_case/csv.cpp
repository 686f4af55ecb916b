#include "csv.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "fields.h"
#include "fusee/core/csv.h"
#include "fusee/core/file.h"

namespace fusee::gap_case {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kMostTorques = 20.0;     // times the springs' greatest torque together: 100 would be Ncm
constexpr double kLeastPull = -0.02;      // of the springs' torque: a pull is positive but for its sensor's noise
constexpr double kLongestTime = 1e6;      // [s]
constexpr double kMostCapstanAngle = 60;  // [rad]
constexpr double kMostJointAngle = 10;    // [rad]

struct Allowed {
    core::Range range;
    std::string text;
};

/// Limits of a value on this rig: beyond them it is in another unit.
Allowed allowed(Quantity quantity, const NominalRig& rig) {
    const double springs = rig.springs.back().se_torque + rig.springs.back().pe_torque;
    const double pull = kMostTorques * springs, joint = pull * std::max(rig.ratio(), 1.0);
    const auto torque = [springs](core::Range range, const char* more) {
        return Allowed{range, fmt::format("{:g} to {:g} Nm, as the springs have {:g} Nm at most{}", range.low, range.high, springs, more)};
    };
    const auto angle = [](double most) { return Allowed{{-most, most}, fmt::format("{:g} to {:g} rad; are these degrees?", -most, most)}; };
    switch (quantity) {
        case Quantity::kCount:
            return {{1, 1e6}, "a whole number from 1 on"};
        case Quantity::kTime:
            return {{-kLongestTime, kLongestTime}, fmt::format("{:g} to {:g} s", -kLongestTime, kLongestTime)};
        case Quantity::kDeflection:
        case Quantity::kCapstanAngle:
            return angle(kMostCapstanAngle);
        case Quantity::kJointAngle:
            return angle(kMostJointAngle);
        case Quantity::kPull:
            return torque({kLeastPull * springs, pull}, ", positive when it winds the capstan's cable in");
        case Quantity::kTorque:
            return torque({-pull, pull}, "");
        case Quantity::kJointTorque:
            return torque({-joint, joint}, "");
        case Quantity::kWord:
            break;
    }
    return {};
}

/// One file of an experiment.
template <class Row>
class TableReader {
public:
    TableReader(const CaseFiles& files, std::string name, const Case& gap_case, Experiment experiment, const TablesOptions& options)
        : files_(files), name_(std::move(name)), experiment_(experiment), rig_(gap_case.rig), options_(options) {
        if (const auto own = gap_case.columns.find(experiment); own != gap_case.columns.end()) maps_ = own->second;
        table_ = read();
    }

    [[nodiscard]] std::vector<Row> rows() {
        std::vector<Row> rows(table_.rows());
        for (const Field<Row>& field : fields<Row>()) {
            if (table_.has(field.column))
                field.words.empty() ? fill_numbers(rows, field) : fill_words(rows, field);
            else if (field.measured)
                for (Row& row : rows) field.set(row, kNothing);
        }
        finish(rows);
        if (!options_.inputs_only) leave_out_gaps(rows);
        return rows;
    }
    [[nodiscard]] const core::CsvTable& table() const { return table_; }
    /// Lines of rows without a number in a measured column.
    [[nodiscard]] const std::vector<std::size_t>& left_out() const { return left_out_; }

private:
    [[nodiscard]] core::CsvTable read() const {
        std::vector<core::CsvColumn> columns;
        for (const Field<Row>& field : fields<Row>()) {
            const bool lax = options_.inputs_only && field.measured;
            columns.push_back({.name = field.column,
                               .kind = field.words.empty() ? core::CsvColumn::Kind::kNumber : core::CsvColumn::Kind::kText,
                               .required = (field.required || maps_.contains(field.column)) && !lax,
                               .gaps = field.measured,
                               .header = map_of(field.column).header,
                               .scale = map_of(field.column).factor});
        }
        core::CsvOptions limits;
        limits.mapping.table = std::string("columns.") + to_string(experiment_);
        limits.most_kept = options_.inputs_only ? limits.most_rows : kLongestTable;
        if (!options_.inputs_only) {
            limits.most_rows = kMostRows;
            limits.largest_bytes = kLargestTable;
            if constexpr (std::is_same_v<Row, LogRow>) {
                limits.span_column = "t_s";
                limits.longest_span = kLongestLog;
            }
        }
        return files_.read_csv(name_, columns, limits, options_.seen);
    }

    void fill_words(std::vector<Row>& rows, const Field<Row>& field) const {
        const std::vector<std::string>& texts = table_.texts(field.column);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto word = std::find(field.words.begin(), field.words.end(), texts[i]);
            if (word == field.words.end())
                throw table_.fault(i, field.column, "'" + texts[i] + "'", fmt::format("{}", fmt::join(field.words, " or ")));
            field.set(rows[i], static_cast<double>(word - field.words.begin()));
        }
    }

    void fill_numbers(std::vector<Row>& rows, const Field<Row>& field) const {
        const std::vector<double>& numbers = table_.numbers(field.column);
        const Allowed limits = allowed(field.quantity, rig_);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const double number = numbers[i];
            const bool whole = field.quantity != Quantity::kCount || number == std::floor(number);
            if (!std::isnan(number) && (!limits.range.holds(number) || !whole))
                throw table_.fault(i, field.column, fmt::format("{:g}", number), limits.text);
            field.set(rows[i], number);
        }
    }

    [[nodiscard]] ColumnMap map_of(const std::string& column) const {
        const auto own = maps_.find(column);
        return own == maps_.end() ? ColumnMap{} : own->second;
    }

    /// The first measured column of the file that has no number in a row; null: none.
    [[nodiscard]] const Field<Row>* gap_in(std::size_t row) const {
        const auto& all = fields<Row>();
        const auto gap = std::find_if(all.begin(), all.end(), [&](const Field<Row>& field) {
            return field.measured && table_.has(field.column) && std::isnan(table_.numbers(field.column)[row]);
        });
        return gap == all.end() ? nullptr : &*gap;
    }

    /// Removes the rows that have a measured column without a number. A row of a loop keeps its place in time.
    void leave_out_gaps(std::vector<Row>& rows) {
        std::vector<std::size_t> gaps;
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (gap_in(i) != nullptr) gaps.push_back(i);
        if (gaps.empty()) return;
        if (2 * gaps.size() > rows.size())
            throw table_.fault(gaps.front(), gap_in(gaps.front())->column,
                               fmt::format("{} of {} rows have no number in a measured column", gaps.size(), rows.size()),
                               "at least half of the rows complete; `fusee predict` reads empty templates");
        for (const std::size_t i : gaps) left_out_.push_back(table_.line(i));
        std::vector<Row> whole;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if constexpr (std::is_same_v<Row, StiffnessRow>) rows[i].row = i + 1;
            if (gap_in(i) == nullptr) whole.push_back(rows[i]);
        }
        rows = std::move(whole);
    }

    void finish(std::vector<Row>& rows) const {
        if constexpr (std::is_same_v<Row, BreakAway>)
            for (std::size_t i = 0; i < rows.size(); ++i) rows[i].line = table_.line(i);
        if constexpr (std::is_same_v<Row, DeadBandRow>) finish_widths(rows);
        if constexpr (std::is_same_v<Row, StiffnessRow>)
            if (!options_.inputs_only) level(rows);
        if constexpr (std::is_same_v<Row, LogRow>)
            for (std::size_t i = 1; i < rows.size(); ++i)
                if (rows[i].time <= rows[i - 1].time)
                    throw table_.fault(i, "t_s", fmt::format("{:g}", rows[i].time),
                                       fmt::format("after the row before, {:g} s", rows[i - 1].time));
    }

    /// Co-contractions may be measured instead of commanded: close values are one level, their mean. Otherwise each row would
    /// begin a separate loop from rest.
    void level(std::vector<StiffnessRow>& rows) const {
        constexpr double kApart = 0.01, kWidest = 0.04;  // of the greatest
        std::map<double, std::size_t> counts;
        for (const StiffnessRow& row : rows) ++counts[row.cocontraction];
        const double most = std::abs(counts.rbegin()->first);
        std::map<double, double> level_of;
        for (auto first = counts.begin(), last = first; first != counts.end(); first = last) {
            double before = first->first, sum = 0.0, count = 0.0;
            for (; last != counts.end() && last->first - before <= kApart * most; ++last) {
                before = last->first;
                count += static_cast<double>(last->second);
                sum += static_cast<double>(last->second) * before;
            }
            const bool one = std::next(first) == last || before - first->first > kWidest * most;
            for (auto each = first; each != last; ++each) level_of[each->first] = one ? each->first : sum / count;
        }
        std::set<double> levels;
        for (StiffnessRow& row : rows) levels.insert(row.cocontraction = level_of.at(row.cocontraction));
        if (levels.size() < counts.size() && options_.remarks != nullptr)
            options_.remarks->push_back(
                fmt::format("{}: co-contractions within 1 % of each other are one level, as commanded: {} in place of {}",
                            fs::path(name_).filename().string(), levels.size(), counts.size()));
    }

    /// Both ends, or only the width.
    void finish_widths(std::vector<DeadBandRow>& rows) const {
        const bool ends = table_.has("q_low_rad") && table_.has("q_high_rad");
        if (!options_.inputs_only && !ends && !table_.has("width_rad"))
            throw core::InvalidInput((files_.folder() / name_).string() + ": header", "no dead-band",
                                     "q_low_rad and q_high_rad, or width_rad alone");
        for (std::size_t i = 0; i < rows.size(); ++i) {
            DeadBandRow& row = rows[i];
            if (!ends) row.q_low = row.q_high = kNothing;
            if (ends) row.width = row.q_high - row.q_low;
        }
    }

    const CaseFiles& files_;
    std::string name_;
    Experiment experiment_;
    const NominalRig& rig_;
    const TablesOptions& options_;
    std::map<std::string, ColumnMap> maps_;
    core::CsvTable table_;
    std::vector<std::size_t> left_out_;
};

/// "12 of 240 rows are left out, without a number in a measured column: lines 14, 15, ...".
void tell_gaps(const std::string& file, const std::vector<std::size_t>& lines, std::size_t rows, std::vector<std::string>& remarks) {
    constexpr std::size_t kShown = 5;
    if (lines.empty()) return;
    const std::vector<std::size_t> first(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(std::min(kShown, lines.size())));
    remarks.push_back(fmt::format("{}: {} of {} rows are left out, without a number in a measured column: line{} {}{}", file, lines.size(),
                                  rows, lines.size() > 1 ? "s" : "", fmt::join(first, ", "), lines.size() > kShown ? ", ..." : ""));
}

void tell_left_out(const std::string& file, const core::CsvTable& table, std::vector<std::string>& remarks) {
    if (table.rows_beyond_span() > 0)
        remarks.push_back(fmt::format("{}: of {} rows the first {:g} s are used, {} rows are left out", file, table.rows_read(),
                                      kLongestLog, table.rows_beyond_span()));
    if (table.stride() > 1)
        remarks.push_back(fmt::format("{}: every {}th row is used, {} of {}; the rows in between are ignored", file, table.stride(),
                                      table.rows(), table.rows_read() - table.rows_beyond_span()));
}

template <class Row>
void read_experiment(const Case& gap_case, const CaseFiles& files, const TablesOptions& options, Experiment experiment, Rows& all,
                     std::vector<Row>& rows) {
    const auto named = gap_case.files.find(experiment);
    if (named == gap_case.files.end()) return;
    for (const std::string& name : named->second) {
        std::size_t& part = all.parts[experiment].emplace_back(0);
        if (options.inputs_only && !files.has(name)) continue;
        TableReader<Row> reader(files, name, gap_case, experiment, options);
        const std::vector<Row> read = reader.rows();
        part = read.size();
        rows.insert(rows.end(), read.begin(), read.end());
        if (options.remarks != nullptr) {
            tell_left_out(name, reader.table(), *options.remarks);
            tell_gaps(name, reader.left_out(), reader.table().rows(), *options.remarks);
        }
        if constexpr (std::is_same_v<Row, DeadBandRow>)
            all.dead_band_width_only |= reader.table().has("width_rad") && std::isnan(read.front().q_low);
    }
}

}  // namespace

Rows read_tables(const Case& gap_case, const CaseFiles& files, const TablesOptions& options) {
    Rows all;
    for_each_experiment(all, [&](Experiment experiment, auto& rows) { read_experiment(gap_case, files, options, experiment, all, rows); });
    return all;
}

std::vector<NominalRig::SpringRow> read_springs(const CaseFiles& files, const std::string& file,
                                                const std::function<void(std::string_view)>& seen) {
    constexpr std::size_t kLeast = 8;
    constexpr double kMostTorque = 1e6;  // [Nm], far above any joint
    const core::CsvTable table = files.read_csv(file, {{"deflection_rad"}, {"se_torque_Nm"}, {"pe_torque_Nm"}},
                                                {.least_rows = kLeast, .most_rows = kLongestTable}, seen);
    const std::vector<double>& deflection = table.numbers("deflection_rad");
    std::vector<NominalRig::SpringRow> rows;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        if (i == 0 ? deflection[0] != 0.0 : deflection[i] <= deflection[i - 1])
            throw table.fault(i, "deflection_rad", fmt::format("{:g}", deflection[i]),
                              i == 0 ? "0, the relaxed spring" : fmt::format("above the row before, {:g}", deflection[i - 1]));
        if (deflection[i] > kMostCapstanAngle)
            throw table.fault(i, "deflection_rad", fmt::format("{:g}", deflection[i]),
                              fmt::format("0 to {:g} rad; are these degrees?", kMostCapstanAngle));
        for (const char* column : {"se_torque_Nm", "pe_torque_Nm"}) {
            const std::vector<double>& torque = table.numbers(column);
            const std::string value = fmt::format("{:g}", torque[i]);
            if (i == 0 && torque[0] != 0.0) throw table.fault(i, column, value, "0 at deflection 0: a law without preload");
            if (i > 0 && torque[i] < torque[i - 1])
                throw table.fault(i, column, value, fmt::format("not below the row before, {:g}", torque[i - 1]));
            if (torque[i] > kMostTorque || (i + 1 == table.rows() && torque[i] == 0.0))
                throw table.fault(i, column, value, fmt::format("above 0, at most {:g} Nm", kMostTorque));
        }
        rows.push_back({deflection[i], table.numbers("se_torque_Nm")[i], table.numbers("pe_torque_Nm")[i]});
    }
    return rows;
}

}  // namespace fusee::gap_case
