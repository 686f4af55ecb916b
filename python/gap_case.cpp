#include "gap_case.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "arrays.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/text.h"
#include "fusee/pipeline/rig.h"
#include "fusee/profile/places.h"

namespace fs = std::filesystem;

namespace fusee::python {

namespace {

using gap_case::Experiment;

const char* const kSpringsFile = "nominal_springs.csv";

/// A cell as text: the shortest digits that give the number back; nothing for NaN.
std::string cell_of(const py::handle& cell) {
    if (py::isinstance<py::str>(cell)) return cell.cast<std::string>();
    const double number = cell.cast<double>();
    return std::isnan(number) ? "" : fmt::format("{}", number);
}

}  // namespace

std::string csv_of(const std::string& file, const py::dict& columns) {
    std::vector<std::string> names;
    std::vector<py::list> cells;
    for (const auto& [name, column] : columns) {
        names.push_back(name.cast<std::string>());
        cells.emplace_back(py::hasattr(column, "tolist") ? column.attr("tolist")() : py::reinterpret_borrow<py::object>(column));
        if (cells.back().size() != cells.front().size())
            throw core::InvalidInput(file + ": " + names.back(), fmt::format("{} rows", cells.back().size()),
                                     fmt::format("{} rows, as {} has", cells.front().size(), names.front()));
    }
    std::string text = fmt::format("{}\n", fmt::join(names, ","));
    for (std::size_t row = 0; !cells.empty() && row < cells.front().size(); ++row) {
        for (std::size_t k = 0; k < cells.size(); ++k) text += (k == 0 ? "" : ",") + cell_of(cells[k][row]);
        text += '\n';
    }
    return text;
}

namespace {

std::string springs_csv(const py::dict& rig) {
    if (!rig.contains("springs"))
        throw core::InvalidInput("rig: springs", "missing", "a table with deflection_rad, se_torque_Nm, pe_torque_Nm");
    return csv_of("springs", rig["springs"].cast<py::dict>());
}

std::string toml_table(const std::string& name, const py::dict& numbers) {
    std::string text = fmt::format("\n[{}]\n", name);
    for (const auto& [key, value] : numbers) {
        const std::string word = key.cast<std::string>();
        if (name == "rig" && word == "springs") continue;
        text += fmt::format("{} = {}\n", word,
                            py::isinstance<py::str>(value) ? fmt::format("\"{}\"", value.cast<std::string>()) : cell_of(value));
    }
    return text;
}

gap_case::Case from_arrays(const std::string& name, const py::dict& rig, const py::dict& experiments, const py::dict& sensors,
                           const py::dict& tolerance, const py::dict& protocol) {
    gap_case::CaseTexts texts;
    texts[kSpringsFile] = springs_csv(rig);
    std::string toml = toml_table("rig", rig) + fmt::format("springs = \"{}\"\n", kSpringsFile);
    toml += toml_table("sensors", sensors) + toml_table("tolerance", tolerance) + toml_table("protocol", protocol) + "\n[experiments]\n";
    for (const auto& [experiment, columns] : experiments) {
        const std::string word = experiment.cast<std::string>(), file = word + ".csv";
        texts[file] = csv_of(file, columns.cast<py::dict>());
        toml += fmt::format("{} = \"{}\"\n", word, file);
    }
    texts["case.toml"] = std::move(toml);
    return gap_case::read_case(gap_case::CaseFiles(name, texts));
}

/// A table with named columns: a DataFrame, a dictionary of arrays.
py::dict columns_of_frame(const std::string& experiment, const py::object& frame, const py::dict& names) {
    const py::object headers = py::hasattr(frame, "columns") ? frame.attr("columns") : frame;
    std::vector<std::string> known;
    for (const py::handle& header : headers) known.push_back(py::str(header).cast<std::string>());
    py::dict columns;
    for (const std::string& header : known) columns[header.c_str()] = frame[py::str(header)];
    for (const auto& [name, header] : names) {
        const std::string wanted = name.cast<std::string>(), own = py::str(header).cast<std::string>();
        if (std::find(known.begin(), known.end(), own) == known.end())
            throw core::InvalidInput(fmt::format("columns: {}.{}", experiment, wanted), own,
                                     fmt::format("{}{}", fmt::join(known, ", "), core::did_you_mean(own, known)));
        if (own != wanted) columns.attr("pop")(own);
        columns[wanted.c_str()] = frame[py::str(own)];
    }
    return columns;
}

/// One table of one experiment, or a dictionary of tables by experiment.
gap_case::Case from_frame(const py::object& frame, const std::string& name, const py::dict& rig, const std::string& experiment,
                          const py::dict& columns, const py::dict& sensors, const py::dict& tolerance, const py::dict& protocol) {
    py::dict experiments;
    if (!experiment.empty()) {
        experiments[experiment.c_str()] = columns_of_frame(experiment, frame, columns);
        return from_arrays(name, rig, experiments, sensors, tolerance, protocol);
    }
    if (!py::isinstance<py::dict>(frame))
        throw core::InvalidInput("experiment", "missing", "the name of the table's experiment; or a dictionary of tables by experiment");
    for (const auto& [word, table] : frame.cast<py::dict>()) {
        const py::dict names = columns.contains(word) ? columns[word].cast<py::dict>() : py::dict();
        experiments[word] = columns_of_frame(word.cast<std::string>(), py::reinterpret_borrow<py::object>(table), names);
    }
    return from_arrays(name, rig, experiments, sensors, tolerance, protocol);
}

py::dict as_arrays(const gap_case::Rows& rows, Experiment experiment) {
    py::dict columns;
    for (const gap_case::Column& column : gap_case::columns_of(rows, experiment)) {
        if (const auto* words = std::get_if<std::vector<std::string>>(&column.cells)) {
            columns[column.name.c_str()] = py::module_::import("numpy").attr("array")(*words);
        } else {
            auto values = std::make_shared<const std::vector<double>>(std::get<std::vector<double>>(column.cells));
            columns[column.name.c_str()] = numbers(values, *values);
        }
    }
    return columns;
}

py::array_t<double> spring_column(const gap_case::NominalRig& rig, double gap_case::NominalRig::SpringRow::*member) {
    py::array_t<double> cells(static_cast<py::ssize_t>(rig.springs.size()));
    for (std::size_t i = 0; i < rig.springs.size(); ++i) cells.mutable_data()[i] = rig.springs[i].*member;
    return cells;
}

/// A table of the empty case, as Case.from_arrays takes it. Without a case: no keys.
py::dict table_of(const EmptyCase& empty, const char* name) {
    if (!empty.value) return {};
    const std::string toml = gap_case::case_template_texts(*empty.value).at("case.toml");
    py::dict table = py::module_::import("tomllib").attr("loads")(toml)[name];
    if (std::string(name) != "rig") return table;
    using Row = gap_case::NominalRig::SpringRow;
    py::dict springs;
    springs["deflection_rad"] = spring_column(empty.value->rig, &Row::deflection);
    springs["se_torque_Nm"] = spring_column(empty.value->rig, &Row::se_torque);
    springs["pe_torque_Nm"] = spring_column(empty.value->rig, &Row::pe_torque);
    table["springs"] = springs;
    return table;
}

EmptyCase case_template(const py::object& given) {
    const LoadedProfile loaded = profile_of(given);
    const auto made = profile::with_places(loaded.value, [&] { return pipeline::case_template(loaded.value); });
    if (!made) return {std::nullopt, made.refusal()};
    return {*made, {}};
}

/// @throws InvalidInput if there is no case
const gap_case::CaseTemplate& value_of(const EmptyCase& empty) {
    if (!empty.value) throw core::InvalidInput("case_template", "refused", "a profile whose law is a pair of springs: see findings");
    return *empty.value;
}

gap_case::Case filled(const EmptyCase& empty, const py::dict& experiments) {
    return from_arrays(value_of(empty).name, table_of(empty, "rig"), experiments, table_of(empty, "sensors"), table_of(empty, "tolerance"),
                       table_of(empty, "protocol"));
}

void bind_template(py::module_& module) {
    py::class_<EmptyCase> type(module, "CaseTemplate", "A case without measurements: the rig of a profile, and set points.");
    type.def_property_readonly(
            "ok", [](const EmptyCase& e) { return e.value.has_value(); }, "Is the law a pair of springs?")
        .def_readonly("findings", &EmptyCase::findings, "Why the law is no pair of springs.")
        .def_property_readonly(
            "experiments", [](const EmptyCase& e) { return e.value ? arrays_of(gap_case::set_points(*e.value)) : py::dict(); },
            "The set points of each experiment as columns, named as in its file; what is to be measured is NaN.")
        .def("filled", &filled, py::arg("experiments"),
             "The case with measurements, of those experiments only. Raises InvalidInput naming experiment, row and column.")
        .def("__repr__", [](const EmptyCase& e) { return "<CaseTemplate" + (e.value ? " of " + e.value->name : " refused") + ">"; });
    for (const char* name : {"rig", "sensors", "tolerance", "protocol"})
        type.def_property_readonly(
            name, [name](const EmptyCase& e) { return table_of(e, name); }, "As Case.from_arrays takes it.");
    module.def("case_template", &case_template, py::arg("profile"),
               "The empty gap case of the joint that a profile describes: radii, friction, inertias and springs as designed, and set "
               "points for each experiment (docs/gap.md). A case has no preload: springs that rest on stops continue below them to zero "
               "torque, and angles count from there. Raises InvalidInput naming a key that a case cannot hold: no parts, a preload of 0, "
               "friction that is not in proportion to the load.");
}

}  // namespace

gap_case::Case nominal_of(const EmptyCase& empty) {
    const gap_case::CaseTemplate& from = value_of(empty);
    gap_case::Case nominal;
    nominal.name = from.name;
    nominal.rig = from.rig;
    nominal.tolerance = from.tolerance;
    nominal.sensors = from.sensors;
    nominal.protocol = from.protocol;
    for (const Experiment experiment : gap_case::kAllExperiments)
        nominal.files[experiment] = {std::string(gap_case::to_string(experiment)) + ".csv"};
    nominal.rows = gap_case::set_points(from);
    return nominal;
}

py::dict arrays_of(const gap_case::Rows& rows) {
    py::dict experiments;
    for (const Experiment experiment : gap_case::kAllExperiments)
        if (rows.size(experiment) > 0) experiments[gap_case::to_string(experiment)] = as_arrays(rows, experiment);
    return experiments;
}

gap_case::Rows inputs_of(const gap_case::Case& nominal, const py::dict& experiments) {
    gap_case::CaseTexts texts;
    for (const auto& [experiment, columns] : experiments) {
        const auto named =
            std::find_if(nominal.files.begin(), nominal.files.end(),
                         [word = experiment.cast<std::string>()](const auto& one) { return gap_case::to_string(one.first) == word; });
        if (named == nominal.files.end()) throw core::InvalidInput("inputs", experiment.cast<std::string>(), "an experiment of the case");
        texts[named->second.front()] = csv_of(named->second.front(), columns.cast<py::dict>());
    }
    return gap_case::read_inputs(nominal, gap_case::CaseFiles("inputs", texts));
}

void bind_gap_case(py::module_& module) {
    py::class_<gap_case::Case>(module, "Case", "A gap case: nominal rig and measurements (docs/gap.md).")
        .def(py::init([](const fs::path& folder) { return gap_case::read_case(folder); }), py::arg("folder"),
             "Reads the folder of a gap case: case.toml and the CSV files that it names. Figures in another unit (a friction of 22, a "
             "radius of 15 m) are refused with the unit that is needed. Of a very long log the beginning is used and a large file is "
             "thinned; `remarks` say so. A row without a number in a measured column is left out. Raises InvalidInput naming file, line, "
             "column and key, and IoError.")
        .def_static(
            "from_arrays", &from_arrays, py::arg("name"), py::arg("rig"), py::arg("experiments"), py::kw_only(),
            py::arg("sensors") = py::dict(), py::arg("tolerance") = py::dict(), py::arg("protocol") = py::dict(),
            "A case from memory, read with every check of a folder. Keys and columns are those of docs/gap.md, with their units: `rig` "
            "with its numbers and `springs`, the columns deflection_rad, se_torque_Nm, pe_torque_Nm; `experiments` by name with the "
            "columns of their files. Raises InvalidInput naming file, line and column as if the arrays were files.")
        .def_static(
            "from_frame", &from_frame, py::arg("frame"), py::arg("name"), py::arg("rig"), py::kw_only(), py::arg("experiment") = "",
            py::arg("columns") = py::dict(), py::arg("sensors") = py::dict(), py::arg("tolerance") = py::dict(),
            py::arg("protocol") = py::dict(),
            "A case from tables with named columns (pandas, polars, dictionaries of arrays), in the units of docs/gap.md. `frame` is "
            "the table of `experiment`, such as \"log\", or a dictionary of tables by experiment. `columns` maps names of docs/gap.md "
            "to those of the table, {\"q_rad\": \"joint\"}, or of several tables by experiment; other columns are skipped. `rig` and "
            "the other tables are as in from_arrays. Raises InvalidInput naming file, line and column as if they were files.")
        .def_property_readonly(
            "name", [](const gap_case::Case& c) { return c.name; }, doc("gap_case::Case::name"))
        .def_property_readonly(
            "sha256", [](const gap_case::Case& c) { return c.sha256; }, doc("gap_case::Case::sha256"))
        .def_property_readonly(
            "remarks", [](const gap_case::Case& c) { return c.remarks; }, doc("gap_case::Case::remarks"))
        .def_property_readonly(
            "experiments", [](const gap_case::Case& c) { return arrays_of(c.rows); },
            "The rows of each experiment as columns, named as in its file.")
        .def("__repr__", [](const gap_case::Case& c) { return fmt::format("<Case {}, {} rows>", c.name, c.rows.size()); });
    bind_template(module);
}

}  // namespace fusee::python
