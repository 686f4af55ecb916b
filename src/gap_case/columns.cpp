#include "fusee/gap_case/columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "fields.h"
#include "fusee/core/csv.h"
#include "fusee/core/lists.h"
#include "fusee/core/units.h"
#include "fusee/gap_case/likely_unit.h"

namespace fusee::gap_case {

namespace {

/// A unit and its factor to the format's unit; with `constant`, the key of the number that makes the factor.
struct Unit {
    const char* name;
    double factor;
    const char* constant = nullptr;
    bool divides = false;  ///< the factor is over that number
};
using Units = std::vector<Unit>;

/// The units of a quantity that any table may have, and those of a lab's log alone. @param to the format's unit; null: the SI unit
Units with_measured(const char* quantity, Units units, const core::MeasureUnit* to = nullptr) {
    const auto measured = core::measure_units(quantity);
    for (std::size_t i = measured.size(); i-- > 0;)
        units.insert(units.begin(), {measured[i].name, measured[i].to(to == nullptr ? measured.front() : *to, 1.0)});
    return units;
}

/// Of a column whose name has its unit.
Units units_named(const std::string& column) {
    const core::MeasureUnit* const unit = core::measured_name(column).unit;
    if (unit == nullptr) return {};
    const std::string_view quantity = unit->quantity;
    Units more;
    if (quantity == "angle") more = {{"count", core::measure_units("angle").front().to(*unit, 2.0 * core::kPi), "counts_per_turn", true}};
    if (quantity == "torque") more = {{"A", core::measure_units("torque").front().to(*unit, 1.0), "Nm_per_A"}};
    return with_measured(unit->quantity, std::move(more), unit);
}

const Units& units_of(Quantity quantity) {
    static const Units angles = with_measured("angle", {{"count", 2.0 * core::kPi, "counts_per_turn", true}}),
                       torques = with_measured("torque", {{"A", 1.0, "Nm_per_A"}}), times = with_measured("time", {}), none;
    switch (quantity) {
        case Quantity::kTime:
            return times;
        case Quantity::kDeflection:
        case Quantity::kCapstanAngle:
        case Quantity::kJointAngle:
            return angles;
        case Quantity::kPull:
        case Quantity::kTorque:
        case Quantity::kJointTorque:
            return torques;
        case Quantity::kWord:
        case Quantity::kCount:
            break;
    }
    return none;
}

double number_at(const CaseToml& toml, const std::string& path, const char* allowed) {
    double value = std::numeric_limits<double>::quiet_NaN();
    if (toml.has(path))
        if (const auto* number = std::get_if<double>(&toml.at(path))) value = *number;
    if (!std::isfinite(value) || value == 0.0) throw toml.fault(path, toml.has(path) ? "no such number" : "missing", allowed);
    return value;
}

std::optional<double> factor_of(const CaseToml& toml, const std::string& path, const Units& units) {
    if (!toml.has(path + ".factor") && !toml.has(path + ".unit")) return {};
    double factor = toml.has(path + ".factor") ? number_at(toml, path + ".factor", "a finite number other than 0") : 1.0;
    if (!toml.has(path + ".unit")) return factor;
    auto names = core::each<const char*>(units, &Unit::name);
    const std::string allowed = names.empty() ? "no unit: this column has none" : fmt::format("{}", fmt::join(names, ", "));
    const std::string name = toml.text(path + ".unit", allowed);
    const core::MeasureUnit* spelt = core::find_measure_unit(name);
    const auto unit = std::find_if(units.begin(), units.end(), [&](const Unit& u) {
        return name == u.name || (spelt != nullptr && std::string_view(spelt->name) == u.name);
    });
    if (unit == units.end()) throw toml.fault(path + ".unit", '"' + name + '"', allowed);
    factor *= unit->factor;
    if (unit->constant == nullptr) return factor;
    const double constant = number_at(toml, path + "." + unit->constant, "a finite number other than 0: the unit needs it");
    return unit->divides ? factor / constant : factor * constant;
}

ColumnMap map_at(const CaseToml& toml, const std::string& path, const Units& units) {
    const char* const allowed = "the column's name in the file";
    if (!toml.has_table(path)) return {toml.text(path, allowed), {}};
    std::vector<std::string> keys{"column", "unit", "factor"};
    for (const Unit& unit : units)
        if (unit.constant != nullptr) keys.emplace_back(unit.constant);
    (void)toml.read_numbers(path, {}, keys);
    return {toml.text(path + ".column", allowed), factor_of(toml, path, units)};
}

template <class Visit>
void for_each_column(const Visit& visit) {
    Rows none;
    for_each_experiment(none, [&]<class Row>(Experiment experiment, const std::vector<Row>&) {
        for (const Field<Row>& field : fields<Row>()) visit(experiment, field.column, field.quantity);
    });
}

std::string table_of(Experiment experiment) { return std::string("columns.") + to_string(experiment); }

}  // namespace

ColumnMap read_column(const CaseToml& toml, const std::string& path, const std::string& column) {
    return map_at(toml, path, units_named(column));
}

ColumnMaps read_columns(const CaseToml& toml) {
    ColumnMaps maps;
    std::map<Experiment, std::vector<std::string>> known;
    for_each_column([&](Experiment experiment, const std::string& column, Quantity quantity) {
        known[experiment].push_back(column);
        const std::string path = table_of(experiment) + "." + column;
        if (toml.has(path)) maps[experiment][column] = map_at(toml, path, units_of(quantity));
    });
    for (const auto& [experiment, names] : known) (void)toml.read_numbers(table_of(experiment), {}, names);
    return maps;
}

std::vector<std::string> column_tables() {
    std::vector<std::string> names{"columns"};
    for (const Experiment experiment : kAllExperiments) names.push_back(table_of(experiment));
    for_each_column(
        [&](Experiment experiment, const std::string& column, Quantity) { names.push_back(table_of(experiment) + "." + column); });
    return names;
}

std::string likely_unit(double ratio, const std::vector<OtherUnit>& units) {
    const auto far = [ratio](const OtherUnit& unit) { return std::abs(std::log(ratio / unit.count)); };
    const auto nearest =
        std::min_element(units.begin(), units.end(), [&](const OtherUnit& a, const OtherUnit& b) { return far(a) < far(b); });
    return ratio > 0.0 && nearest != units.end() ? fmt::format("; {}?", nearest->question) : "";
}

bool counted_in(const std::vector<double>& readings, double step) {
    constexpr double kOff = 0.05;          // of a step: by chance one reading in ten is as near
    constexpr std::size_t kDifferent = 8;  // counts: an axis that stays where it is may stand near one or two
    std::set<double> counts;
    for (const double reading : readings) {
        const double count = std::round(reading / step);
        if (std::abs(reading / step - count) > kOff) return false;
        counts.insert(count);
    }
    return counts.size() >= kDifferent;
}

double step_of(std::vector<double> readings) {
    constexpr double kRounding = 1e-9;  // of the readings' range
    std::sort(readings.begin(), readings.end());
    const double range = readings.empty() ? 0.0 : readings.back() - readings.front();
    double least = 0.0;
    for (std::size_t i = 1; i < readings.size(); ++i)
        if (const double step = readings[i] - readings[i - 1]; step > kRounding * range && (least == 0.0 || step < least)) least = step;
    return least;
}

}  // namespace fusee::gap_case
