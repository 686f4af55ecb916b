#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "described.h"
#include "experiments.h"
#include "fusee/core/csv.h"
#include "fusee/core/file.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"
#include "fusee/gap_case/columns.h"
#include "fusee/gap_case/toml.h"
#include "fusee/simulator/case.h"

namespace fusee::simulator {

std::string Experiment::time() const { return std::count(inputs.begin(), inputs.end(), "t_s") > 0 ? "t_s" : ""; }

std::string unit_in(const std::string& name) {
    static constexpr std::string_view kMore[] = {"kgm2", "Nms", "kg", "g", "ohm", "H", "A", "V", "K", "Hz"};
    const std::size_t per = name.find("_per_"), first = per == std::string::npos || per == 0 ? per : name.rfind('_', per - 1);
    if (first != std::string::npos && first > 0) return name.substr(first + 1);  // "torque_constant_Nm_per_A"
    if (const std::string unit = core::measured_name(name).unit_text; !unit.empty()) return unit;
    for (const std::string_view unit : kMore)
        if (name.size() > unit.size() + 1 && name.ends_with(unit) && name[name.size() - unit.size() - 1] == '_') return std::string(unit);
    return "1";
}

namespace {

using gap_case::CaseToml;

constexpr double kMost = 1e30;              // of any figure
constexpr double kMuchRougher = 3.0;        // than every input, relative to the spans: then an output scatters by itself
constexpr double kLongestTimeout_s = 3600;  // of one answer
constexpr std::size_t kLeastRows = 4, kMostRows = 1'000'000;
const char* const kNames = "an array of names";

/// "inertia_kgm2": what may stand as a key on both sides of the process.
bool is_name(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    });
}

/// The tables directly below `table`.
std::vector<std::string> tables_of(const CaseToml& toml, const std::string& table) {
    std::vector<std::string> names;
    for (const std::string& name : toml.tables_below(table)) {
        if (!is_name(name)) throw toml.fault(table + "." + name, "\"" + name + "\"", "a name of letters, figures, _ and -");
        names.push_back(name);
    }
    return names;
}

double number_of(const CaseToml& toml, const std::string& path, double low, double high, double otherwise) {
    double value = otherwise;
    const std::size_t dot = path.rfind('.');
    const gap_case::NumberKey key{path.substr(dot + 1), low, high, "", &value, "", ""};
    if (toml.has(path)) (void)toml.read_numbers(path.substr(0, dot), {key}, toml.keys_of(path.substr(0, dot)));
    return value;
}

std::vector<std::string> names_at(const CaseToml& toml, const std::string& path, const char* allowed) {
    if (!toml.has(path)) throw toml.fault(path, "missing", allowed);
    if (const auto* text = std::get_if<std::string>(&toml.at(path)); text != nullptr && !text->empty()) return {*text};
    const auto* texts = std::get_if<std::vector<std::string>>(&toml.at(path));
    if (texts == nullptr) throw toml.fault(path, "no texts", allowed);
    return *texts;
}

/// A number or an array of them.
std::vector<double> numbers_at(const CaseToml& toml, const std::string& path, std::size_t count, const std::string& allowed) {
    if (!toml.has(path)) throw toml.fault(path, "missing", allowed);
    std::vector<double> numbers;
    if (const auto* one = std::get_if<double>(&toml.at(path))) numbers = {*one};
    if (const auto* many = std::get_if<std::vector<double>>(&toml.at(path))) numbers = *many;
    const bool finite = std::all_of(numbers.begin(), numbers.end(), [](double value) { return std::abs(value) <= kMost; });
    if (numbers.size() != count || !finite) throw toml.fault(path, fmt::format("{} such numbers", numbers.size()), allowed);
    return numbers;
}

/// With model.mjcf, what the file holds is asked for: the case adds to it. The model file is part of the case's hash.
void read_mjcf(const CaseToml& toml, core::Sha256& hash, Case& to) {
    const std::string file = toml.text("model.mjcf", "the file of a MuJoCo model, arm.xml");
    const fs::path path = to.model.parent_path() / file;
    if (!fs::is_regular_file(path)) throw toml.fault("model.mjcf", file + " not found", "a file, named from the folder of this one");
    hash.add(core::read_file(path));
    const std::string place = toml.fault("model.mjcf", "", "").field();
    if (to.command.empty()) to.command = {mujoco_companion(place)};
    to.command.push_back(file);
    ask_description(place, to);
}

void read_model(const CaseToml& toml, bool needs_command, core::Sha256& hash, Case& to) {
    (void)toml.read_numbers("model", {}, {"command", "mjcf", "timeout_s"});
    const bool describes = needs_command && toml.has("model.mjcf");
    const char* const allowed = "the words of the program that simulates, as [\"python3\", \"model.py\"]";
    if ((needs_command && !describes) || toml.has("model.command")) {
        to.command = names_at(toml, "model.command", allowed);
        if (needs_command && (to.command.empty() || to.command.front().empty())) throw toml.fault("model.command", "no word", allowed);
    }
    const double timeout_s = number_of(toml, "model.timeout_s", 0.01, kLongestTimeout_s, 60.0);
    to.timeout = std::chrono::milliseconds(static_cast<long>(std::ceil(1e3 * timeout_s)));
    if (describes) read_mjcf(toml, hash, to);
}

/// @param described by the model; null: the case alone knows it
Parameter read_parameter(const CaseToml& toml, const std::string& name, const Parameter* described) {
    const std::string path = "parameters." + name;
    (void)toml.read_numbers(path, {}, {"nominal", "tolerance", "tolerance_abs", "unit"});
    Parameter own{name, toml.has(path + ".unit") ? toml.text(path + ".unit", "a unit") : unit_in(name)};
    if (described == nullptr && !toml.has(path + ".nominal"))
        throw toml.fault(path + ".nominal", "missing", "the value of the model as it is");
    own.nominal = number_of(toml, path + ".nominal", -kMost, kMost, described == nullptr ? 0.0 : described->nominal);
    own.relative = toml.has(path + ".tolerance");
    if (own.relative && toml.has(path + ".tolerance_abs"))
        throw toml.fault(path + ".tolerance", "both", "tolerance, a share of the nominal value, or tolerance_abs, in its unit");
    if (own.relative && own.nominal == 0.0)
        throw toml.fault(path + ".tolerance", "a share of 0", "tolerance_abs, in the unit of the parameter");
    if (own.relative) own.sigma = std::abs(own.nominal) * number_of(toml, path + ".tolerance", 1e-9, 0.5, 0.0);
    if (toml.has(path + ".tolerance_abs")) own.sigma = number_of(toml, path + ".tolerance_abs", 1e-30, kMost, 0.0);
    return own;
}

/// Those that are allowed, and which of them is meant.
std::string names_near(const std::string& name, const std::vector<Parameter>& parameters) {
    auto names = core::each<std::string>(parameters, &Parameter::name);
    return fmt::format("{}{}", fmt::join(names, ", "), core::did_you_mean(name, names));
}

/// Those of the model that describes itself may be stated otherwise, and no other is one.
void read_parameters(const CaseToml& toml, Case& to) {
    const bool described = !to.parameters.empty();
    for (const std::string& name : tables_of(toml, "parameters")) {
        if (Parameter* known = core::find_by(to.parameters, &Parameter::name, name)) {
            *known = read_parameter(toml, name, known);
            continue;
        }
        if (described) throw toml.fault("parameters." + name, "no figure of the model", names_near(name, to.parameters));
        to.parameters.push_back(read_parameter(toml, name, nullptr));
    }
    if (to.parameters.empty()) throw toml.fault("parameters", "no parameter", "[parameters] with NAME = {nominal = VALUE}");
}

std::size_t place_of(const CaseToml& toml, const std::string& path, const std::string& name, const std::vector<Parameter>& parameters) {
    const Parameter* found = core::find_by(parameters, &Parameter::name, name);
    if (found == nullptr) throw toml.fault(path, "\"" + name + "\"", names_near(name, parameters));
    return static_cast<std::size_t>(found - parameters.data());
}

/// Effects that the model describes stay unless the case has one of this name, or the figure has a tolerance now. @pre parameters are read
void keep_described(const CaseToml& toml, Case& to) {
    std::erase_if(to.effects, [&](const Effect& effect) {
        return toml.has_table("effects." + effect.id) || to.parameters[effect.frees.front()].sigma > 0.0;
    });
    for (Effect& effect : to.effects)
        for (std::size_t k = 0; k < effect.frees.size(); ++k) {
            const double nominal = to.parameters[effect.frees[k]].nominal, far = nominal + 10.0 * std::abs(nominal);
            core::Range& range = effect.ranges[k];
            if (!range.holds(nominal)) range = {std::min(range.low, nominal), std::max(range.high, far)};  // the case moved it
        }
}

void read_effects(const CaseToml& toml, Case& to) {
    keep_described(toml, to);
    for (const std::string& id : tables_of(toml, "effects")) {
        const std::string path = "effects." + id;
        (void)toml.read_numbers(path, {}, {"frees", "usual", "range", "meaning", "remedy"});
        Effect own{id, {}, {}, {}, "", ""};
        for (const std::string& name : names_at(toml, path + ".frees", kNames))
            own.frees.push_back(place_of(toml, path + ".frees", name, to.parameters));
        if (own.frees.empty()) throw toml.fault(path + ".frees", "no parameter", kNames);
        const std::size_t n = own.frees.size();
        own.usual = numbers_at(toml, path + ".usual", n, n == 1 ? "a number" : fmt::format("an array of {} numbers", n));
        const auto ends = numbers_at(toml, path + ".range", 2 * n, fmt::format("an array of {} numbers: low, high of each", 2 * n));
        for (std::size_t k = 0; k < n; ++k) {
            const double nominal = to.parameters[own.frees[k]].nominal;
            const core::Range& range = own.ranges.emplace_back(core::Range{ends[2 * k], ends[2 * k + 1]});
            if (!(range.low < range.high && range.holds(nominal)))
                throw toml.fault(path + ".range", fmt::format("{:g} to {:g}", range.low, range.high),
                                 fmt::format("low, then high, with the nominal value, {:g}, between them", nominal));
            const double usual = own.usual[k], most = k == 0 ? std::max(nominal - range.low, range.high - nominal) : kMost;
            if (!(usual > 0.0 && usual <= most))
                throw toml.fault(path + ".usual", fmt::format("{:g}", usual),
                                 fmt::format("a distance from the nominal value: above 0, at most {:g}", most));
        }
        if (toml.has(path + ".meaning")) own.meaning = toml.text(path + ".meaning", "a sentence");
        if (toml.has(path + ".remedy")) own.remedy = toml.text(path + ".remedy", "a sentence");
        to.effects.push_back(std::move(own));
    }
    for (const Effect& effect : to.effects)
        for (const Parameter& parameter : to.parameters)
            if (effect.id == parameter.name && parameter.sigma > 0.0)
                throw toml.fault("effects." + effect.id, "the name of a parameter with a tolerance", "a name of its own");
}

/// The columns of one experiment's files.
std::vector<core::CsvColumn> csv_columns(const CaseToml& toml, const Experiment& experiment) {
    const std::string table = "columns." + experiment.name;
    std::vector<std::string> names = experiment.inputs;
    for (const Output& output : experiment.outputs) names.push_back(output.name);
    if (toml.has_table(table)) {
        std::vector<std::string> here = toml.keys_of(table);
        for (const std::string& inner : toml.tables_below(table)) here.push_back(inner);
        for (const std::string& name : here)
            if (std::find(names.begin(), names.end(), name) == names.end())
                throw toml.fault(table + "." + name, "unknown column", fmt::format("{}", fmt::join(names, ", ")));
    }
    std::vector<core::CsvColumn> columns;
    for (const std::string& name : names) {
        const std::string path = table + "." + name;
        const gap_case::ColumnMap map = toml.has(path) ? gap_case::read_column(toml, path, name) : gap_case::ColumnMap{};
        columns.push_back({.name = name, .header = map.header, .scale = map.factor});
    }
    return columns;
}

/// What CSV files and their hash are read with.
struct Source {
    gap_case::CaseFiles files;
    core::Sha256& hash;
};

/// @param inputs_only outputs need not be there, and files may be missing
void read_runs(const CaseToml& toml, const Source& source, Experiment& experiment, bool inputs_only = false) {
    std::vector<core::CsvColumn> columns = csv_columns(toml, experiment);
    if (inputs_only) columns.resize(experiment.inputs.size());
    core::CsvOptions options{.least_rows = kLeastRows, .most_rows = kMostRows};
    options.mapping.table = "columns." + experiment.name;
    const std::string time = experiment.time();
    for (const std::string& file : toml.files("experiments." + experiment.name + ".files")) {
        if (inputs_only && !source.files.has(file)) continue;
        const core::CsvTable table = source.files.read_csv(file, columns, options, [&](std::string_view bytes) { source.hash.add(bytes); });
        Run& run = experiment.runs.emplace_back();
        run.file = file;
        for (const core::CsvColumn& column : columns) run.columns[column.name] = table.numbers(column.name);
        for (std::size_t i = 1; !time.empty() && i < run.rows(); ++i)
            if (const auto& t = run.columns[time]; !(t[i] > t[i - 1]))
                throw table.fault(i, time, fmt::format("{:g}", t[i]), fmt::format("after the row before, {:g} s", t[i - 1]));
    }
}

/// Scatter of a column from its third differences, over its span.
double roughness_of(const Experiment& experiment, const std::string& column) {
    std::vector<const std::vector<double>*> runs;
    double low = kMost, high = -kMost;
    for (const Run& run : experiment.runs) {
        const std::vector<double>& values = run.columns.at(column);
        runs.push_back(&values);
        low = std::min(low, *std::min_element(values.begin(), values.end()));
        high = std::max(high, *std::max_element(values.begin(), values.end()));
    }
    return high > low ? estimated_noise(runs) / (high - low) : 0.0;
}

/// Is an input about as rough as the output? Then the rows are far apart or the motion jumps, and the output's scatter is no noise.
bool is_driven_roughly(const Experiment& experiment, const std::string& output) {
    const double own = roughness_of(experiment, output);
    return std::any_of(experiment.inputs.begin(), experiment.inputs.end(), [&](const std::string& input) {
        return input != experiment.time() && kMuchRougher * roughness_of(experiment, input) > own;
    });
}

/// @param stated none: it is to be estimated
void measure_noise(const CaseToml& toml, const std::string& path, std::optional<double> stated, const Experiment& experiment,
                   Output& output, Case& to) {
    std::vector<const std::vector<double>*> runs;
    for (const Run& run : experiment.runs) runs.push_back(&run.columns.at(output.name));
    output.sigma = !stated ? estimated_noise(runs) : is_driven_roughly(experiment, output.name) ? *stated : measured_noise(runs, *stated);
    if (!(output.sigma > 0.0))
        throw toml.fault(path, "\"estimate\"", "the standard deviation of its noise: too few rows, or no noise, to estimate it from");
    if (stated == output.sigma) return;
    const std::string times = stated ? fmt::format(", {:.2g} times what was stated", output.sigma / *stated) : "";
    to.remarks.push_back(fmt::format("{}: the noise of {} is estimated from its rows, {:.3g}{}{}{}", experiment.name, output.name,
                                     output.sigma, output.unit == "1" ? "" : " ", output.unit == "1" ? "" : output.unit, times));
}

void read_experiment(const CaseToml& toml, const Source& source, const std::string& name, Case& to) {
    const std::string path = "experiments." + name;
    (void)toml.read_numbers(path, {}, {"files", "inputs"});
    Experiment own{name, names_at(toml, path + ".inputs", kNames), {}, {}};
    const char* const sigmas = "a table: a measured column = standard deviation of its noise, or \"estimate\"";
    std::vector<std::string> outputs = toml.keys_of(path + ".outputs");
    if (outputs.empty()) throw toml.fault(path + ".outputs", "no column", sigmas);
    for (const std::string& column : own.inputs)
        if (!is_name(column) || std::count(own.inputs.begin(), own.inputs.end(), column) > 1 || toml.has(path + ".outputs." + column))
            throw toml.fault(path + ".inputs", "\"" + column + "\"", "names of letters, figures, _ and -, each once, no output");
    for (const std::string& column : outputs) {
        if (!is_name(column)) throw toml.fault(path + ".outputs." + column, "such a name", "letters, figures, _ and -");
        own.outputs.push_back({column, unit_in(column)});
    }
    read_runs(toml, source, own);
    for (Output& output : own.outputs) {
        const std::string at = path + ".outputs." + output.name;
        const auto* text = std::get_if<std::string>(&toml.at(at));
        if (text != nullptr && *text != "estimate") throw toml.fault(at, "\"" + *text + "\"", sigmas);
        std::optional<double> stated;
        if (text == nullptr) stated = numbers_at(toml, at, 1, sigmas).front();
        if (stated && !(*stated > 0.0)) throw toml.fault(at, fmt::format("{:g}", *stated), "above 0");
        measure_noise(toml, at, stated, own, output, to);
    }
    if (const std::size_t stride = stride_of(own); stride > 1)
        to.remarks.push_back(
            fmt::format("{}: one row in {} is compared, from the first of each run on; the simulator has all", name, stride));
    if (own.runs.size() == 1)
        to.remarks.push_back(fmt::format("{}: one run alone: stretches of it are held out in place of whole runs", name));
    to.experiments.push_back(std::move(own));
}

void allow_tables(const CaseToml& toml) {
    std::vector<std::string> known{"model", "experiments", "columns", "parameters", "effects"};
    for (const char* table : {"experiments", "columns", "parameters", "effects"})
        for (const std::string& name : toml.tables_below(table)) {
            known.push_back(std::string(table) + "." + name);
            if (table == std::string_view("experiments")) known.push_back(known.back() + ".outputs");
            if (table == std::string_view("columns"))
                for (const std::string& column : toml.tables_below(known.back()))
                    known.push_back(std::string(table) + "." + name + "." + column);
        }
    toml.allow_tables(known);
    for (const char* table : {"experiments", "columns", "parameters", "effects"})
        for (const std::string& key : toml.keys_of(table))
            throw toml.fault(std::string(table) + "." + key, "no table", fmt::format("[{}.{}], or {} = {{...}}", table, key, key));
}

}  // namespace

Case read_case(const gap_case::CaseFiles& files, bool needs_command, const fs::path& model) {
    const CaseToml toml(files);
    core::Sha256 hash;
    hash.add(toml.bytes());
    Case own;
    own.name = files.name();
    own.folder = files.folder();
    own.model = model.empty() ? own.folder / "case.toml" : model.has_parent_path() ? model : "." / model;
    allow_tables(toml);
    const CaseToml of_model = model.empty() ? toml : CaseToml(gap_case::CaseFiles(own.model.parent_path()), own.model.filename().string());
    if (!model.empty()) hash.add(of_model.bytes());
    allow_tables(of_model);
    read_model(of_model, needs_command, hash, own);
    read_parameters(of_model, own);
    read_effects(of_model, own);
    for (const std::string& name : tables_of(toml, "experiments")) read_experiment(toml, {files, hash}, name, own);
    if (own.experiments.empty()) throw toml.fault("experiments", "no experiment", "[experiments.NAME] with files, inputs and outputs");
    for (const std::string& name : toml.tables_below("columns"))
        if (!toml.has_table("experiments." + name)) throw toml.fault("columns." + name, "unknown experiment", "the name of an experiment");
    own.sha256 = hash.hex();
    return own;
}

void require_same_model(const Case& own, const Case& other) {
    const auto names = [](const Case& of) {
        std::vector<std::string> all;
        for (const Parameter& parameter : of.parameters) all.push_back(fmt::format("parameter {} [{}]", parameter.name, parameter.unit));
        for (const Effect& effect : of.effects) {
            std::vector<std::string> frees;
            for (const std::size_t place : effect.frees) frees.push_back(of.parameters[place].name);
            all.push_back(fmt::format("effect {} (frees {})", effect.id, fmt::join(frees, ", ")));
        }
        std::sort(all.begin(), all.end());
        return all;
    };
    const std::vector<std::string> here = names(own), there = names(other);
    std::vector<std::string> missing, more;
    std::set_difference(here.begin(), here.end(), there.begin(), there.end(), std::back_inserter(missing));
    std::set_difference(there.begin(), there.end(), here.begin(), here.end(), std::back_inserter(more));
    if (missing.empty() && more.empty()) return;
    throw core::InvalidInput(other.model.string(),
                             missing.empty() ? "another model, with " + more.front() : "another model, without " + missing.front(),
                             "the parameters and effects of " + own.model.string());
}

std::vector<Experiment> read_inputs(const Case& of_case, const fs::path& folder) {
    const CaseToml toml{gap_case::CaseFiles(of_case.folder)};
    core::Sha256 unused;
    std::vector<Experiment> all = of_case.experiments;
    std::vector<std::string> files;
    bool any = false;
    for (Experiment& experiment : all) {
        for (const Run& run : experiment.runs) files.push_back(run.file);
        experiment.runs.clear();
        read_runs(toml, {gap_case::CaseFiles(folder), unused}, experiment, true);
        any = any || !experiment.runs.empty();
    }
    if (!any)
        throw core::InvalidInput(folder.string(), "none of the case's files", fmt::format("one or more of {}", fmt::join(files, ", ")));
    return all;
}

Case read_case(const fs::path& folder, const fs::path& model) { return read_case(gap_case::CaseFiles(folder), true, model); }

}  // namespace fusee::simulator
