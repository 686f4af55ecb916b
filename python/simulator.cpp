#include "simulator.h"

#include <fmt/format.h>

#include <cmath>

#include "arrays.h"
#include "fusee/core/error.h"
#include "gap_case.h"

namespace fusee::python {

namespace {

using simulator::Columns, simulator::Request;

py::list list_of(const py::handle& values) {
    return py::hasattr(values, "tolist") ? py::list(values.attr("tolist")()) : py::list(py::reinterpret_borrow<py::object>(values));
}

/// A value as TOML: texts, numbers, lists of them, tables in one line.
std::string toml_of(const py::handle& value) {
    static const char* const kAllowed = "texts, numbers, lists and dicts of them";
    if (py::isinstance<py::str>(value))
        return py::module_::import("json").attr("dumps")(value, py::arg("ensure_ascii") = false).cast<std::string>();
    if (py::isinstance<py::dict>(value)) {
        std::string table;
        for (const auto& [key, inner] : py::reinterpret_borrow<py::dict>(value))
            table += (table.empty() ? "" : ", ") + toml_of(py::str(key)) + " = " + toml_of(inner);
        return "{" + table + "}";
    }
    if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value) || py::isinstance<py::array>(value)) {
        std::string cells;
        for (const py::handle& cell : list_of(value)) cells += (cells.empty() ? "" : ", ") + toml_of(cell);
        return "[" + cells + "]";
    }
    try {
        const std::string number = fmt::format("{}", py::float_(py::reinterpret_borrow<py::object>(value)).cast<double>());
        return number.find_first_of(".en") == std::string::npos ? number + ".0" : number;
    } catch (const py::error_already_set&) {
        throw core::InvalidInput("model", py::repr(value).cast<std::string>(), kAllowed);
    }
}

py::dict dict_in(const py::dict& of, const char* key, const std::string& place) {
    if (!of.contains(key) || !py::isinstance<py::dict>(of[key])) throw core::InvalidInput(place + ": " + key, "missing", "a dict");
    return of[key].cast<py::dict>();
}

/// The same case as a folder has: case.toml, and a CSV file for each run.
gap_case::CaseTexts texts_of(const py::dict& experiments, const py::dict& parameters, const py::dict& effects) {
    gap_case::CaseTexts texts;
    std::string toml = "[model]\n\n[experiments]\n";
    for (const auto& [name, given] : experiments) {
        const std::string word = py::str(name).cast<std::string>(), place = "experiments: " + word;
        if (!py::isinstance<py::dict>(given)) throw core::InvalidInput(place, "no dict", "a dict with runs, inputs and outputs");
        py::dict table;
        py::list files;
        for (const auto& [key, value] : py::reinterpret_borrow<py::dict>(given))
            if (py::str(key).cast<std::string>() != "runs") table[key] = value;
        if (!given.contains("runs"))
            throw core::InvalidInput(place + ": runs", "missing", "a list of runs: each a dict of columns by name");
        for (const py::handle& run : py::list(given["runs"])) {
            const std::string file = fmt::format("{}_{}.csv", word, files.size());
            texts[file] = csv_of(file, py::reinterpret_borrow<py::object>(run).cast<py::dict>());
            files.append(file);
        }
        table["files"] = files;
        (void)dict_in(table, "outputs", place);
        toml += toml_of(py::str(name)) + " = " + toml_of(table) + "\n";
    }
    toml += "\n[parameters]\n";
    for (const auto& [name, value] : parameters) toml += toml_of(py::str(name)) + " = " + toml_of(value) + "\n";
    toml += "\n[effects]\n";
    for (const auto& [name, value] : effects) toml += toml_of(py::str(name)) + " = " + toml_of(value) + "\n";
    texts["case.toml"] = std::move(toml);
    return texts;
}

OwnModel model_of(const py::function& simulate, const py::dict& experiments, const py::dict& parameters, const py::dict& effects,
                  const std::string& name) {
    const gap_case::CaseTexts texts = texts_of(experiments, parameters, effects);
    return {std::make_shared<const simulator::Case>(simulator::read_case(gap_case::CaseFiles(name, texts), false)), simulate};
}

py::dict dict_of(const Columns& columns, const std::vector<std::string>& names) {
    py::dict arrays;
    for (const std::string& name : names)
        arrays[name.c_str()] = py::array_t<double>(static_cast<py::ssize_t>(columns.at(name).size()), columns.at(name).data());
    return arrays;
}

/// @pre the interpreter's lock is held
Columns called(const OwnModel& model, const Request& request) {
    py::dict parameters;
    for (std::size_t p = 0; p < model.value->parameters.size(); ++p)
        parameters[model.value->parameters[p].name.c_str()] = (*request.parameters)[p];
    const py::object answer =
        model.simulate(request.experiment->name, request.run, parameters, dict_of(*request.inputs, request.experiment->inputs));
    Columns outputs;
    if (!py::isinstance<py::dict>(answer))
        throw core::InvalidInput("simulate", py::repr(py::type::of(answer)).cast<std::string>(), "a dict of the outputs by name");
    const auto by_name = answer.cast<py::dict>();
    for (const simulator::Output& output : request.experiment->outputs) {
        if (!by_name.contains(output.name.c_str())) continue;
        const Numbers array = Numbers::ensure(by_name[output.name.c_str()]);
        if (!array) {
            PyErr_Clear();
            throw core::InvalidInput("simulate: " + output.name, "no numbers", "a number for each row");
        }
        outputs[output.name] = vector_of(array);
    }
    if (const std::string fault = simulator::fault_of(outputs, request); !fault.empty())
        throw core::InvalidInput(fmt::format("simulate: run {} of {}", request.run, request.experiment->name), fault,
                                 "every output, finite, a number for each row; raise fusee.Refusal for what cannot be simulated");
    return outputs;
}

}  // namespace

simulator::Simulate simulate_by(const OwnModel& model, Watch& watch) {
    const auto one_call = std::make_shared<std::mutex>();  // a function of Python may have a state of its own
    return [&model, &watch, one_call](const Request& request) {
        const std::scoped_lock alone(*one_call);  // before the interpreter's lock: who holds that never waits for this
        if (watch.stopped()) throw core::Stopped();
        const py::gil_scoped_acquire lock;
        try {
            return called(model, request);
        } catch (py::error_already_set& error) {
            if (error.matches(py::module_::import("fusee.errors").attr("Refusal")))
                throw inference::Refusal(py::str(error.value()).cast<std::string>());
            watch.fail(error);
            throw core::Stopped();
        }
    };
}

void bind_simulator(py::module_& module) {
    py::class_<OwnModel>(module, "Model",
                         "A simulator of your own: a function and what was measured (docs/guides/my-simulator-does-not-match.md).")
        .def(
            py::init(&model_of), py::arg("simulate"), py::arg("experiments"), py::arg("parameters"), py::arg("effects") = py::dict(),
            py::kw_only(), py::arg("name") = "model",
            "`simulate(experiment, run, parameters, inputs)` gets a name, a number from 0, a float for each parameter and an array for "
            "each "
            "input, and returns a dict of the outputs, a number for each row; it raises Refusal for what it cannot simulate. "
            "`experiments` by name: `runs` (a list of dicts of columns), `inputs` (names), `outputs` (standard deviation of the noise of "
            "each, or \"estimate\"). `parameters` and `effects` by name, with the keys of a case.toml. Columns and parameters end in their "
            "unit. Raises InvalidInput.")
        .def_property_readonly(
            "name", [](const OwnModel& m) { return m.value->name; }, "As given.")
        .def_property_readonly(
            "remarks", [](const OwnModel& m) { return m.value->remarks; }, "Limitations: estimated noise, one run.")
        .def("__repr__", [](const OwnModel& m) {
            return fmt::format("<Model {}, {} experiments, {} parameters>", m.value->name, m.value->experiments.size(),
                               m.value->parameters.size());
        });
}

}  // namespace fusee::python
