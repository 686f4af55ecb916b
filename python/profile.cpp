#include <fmt/format.h>

#include <algorithm>

#include "arrays.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/profile/edit.h"
#include "fusee/search/design.h"

namespace fs = std::filesystem;

namespace fusee::python {

namespace {

LoadedProfile parsed(std::string toml, const fs::path& file) {
    profile::Profile value = profile::parse_profile(toml, file);
    return {std::move(value), std::move(toml)};
}

LoadedProfile read(const fs::path& path) { return parsed(core::read_file(path, profile::kLargestFile), path); }

/// A value of Python as TOML writes it. @throws InvalidInput naming the key
std::string literal(const std::string& key, const py::handle& given) {
    const py::object value = py::hasattr(given, "tolist") ? given.attr("tolist")() : py::reinterpret_borrow<py::object>(given);  // NumPy
    if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
    if (py::isinstance<py::str>(value)) return py::module_::import("json").attr("dumps")(value).cast<std::string>();
    if (py::isinstance<py::int_>(value) || py::isinstance<py::float_>(value)) return py::repr(value).cast<std::string>();
    if (!py::isinstance<py::sequence>(value))
        throw core::InvalidInput(key, py::repr(value).cast<std::string>(), "a number, a text, a truth value or a list of them");
    std::string cells;
    for (const py::handle& cell : value) cells += (cells.empty() ? "" : ", ") + literal(key, cell);
    return "[" + cells + "]";
}

py::object value_at(const LoadedProfile& loaded, const std::string& key) {
    profile::require_key("key", key);
    const std::optional<std::string> text = profile::value_text(loaded.value, key);
    if (!text) {
        const std::vector<std::string> keys = profile::key_names();
        const auto inside = std::find_if(keys.begin(), keys.end(), [&key](const std::string& one) { return one.starts_with(key + "."); });
        throw py::key_error(inside == keys.end() ? key + " has no meaning in profile " + loaded.value.name
                                                 : key + " is a table; one of its keys is " + *inside);
    }
    return py::module_::import("tomllib").attr("loads")("value = " + *text)["value"];
}

LoadedProfile with_values(const LoadedProfile& loaded, const py::dict& values, const std::string& why) {
    std::vector<profile::Edit> edits;
    const std::vector<std::string> keys = profile::key_names();
    for (const auto& [name, value] : values) {
        const std::string key = name.cast<std::string>();
        profile::require_key("key", key);
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) throw core::InvalidInput(key, "a table", "a key of a profile");
        edits.push_back({key, literal(key, value), profile::value_text(loaded.value, key).value_or(""), why});
    }
    return parsed(profile::with_edits(loaded.toml, loaded.value, edits), loaded.value.file);
}

LoadedProfile write(const LoadedProfile& loaded, const fs::path& file, bool force) {
    core::require_new_file(file, force);
    const std::vector<profile::Edit> edits = profile::file_edits(loaded.value, fs::absolute(file).parent_path());
    LoadedProfile moved = parsed(profile::with_edits(loaded.toml, loaded.value, edits), file);
    core::write_file(file, moved.toml);
    return moved;
}

/// Torques of both springs over the capstan's angle, and how they are smoothed.
struct Table {
    Numbers angle, series, parallel;
    double start_torque, end_torque;
    int knots;
    double smoothing;
};

void write_table(const fs::path& path, const Table& table) {
    std::string text = "angle_rad,series_Nm,parallel_Nm\n";
    for (py::ssize_t i = 0; i < table.angle.size(); ++i)
        text += fmt::format("{},{},{}\n", table.angle.data()[i], table.series.data()[i], table.parallel.data()[i]);
    core::write_file(path, text);
}

LoadedProfile with_table(const LoadedProfile& loaded, const fs::path& file, const Table& table, bool force) {
    const fs::path csv = fs::path(file).replace_extension(".csv");
    if (file.extension() != ".toml") throw core::InvalidInput("file", file.string(), "a file name that ends in .toml");
    if (table.angle.size() != table.series.size() || table.angle.size() != table.parallel.size())
        throw core::InvalidInput("series, parallel", fmt::format("{}, {} numbers", table.series.size(), table.parallel.size()),
                                 fmt::format("one for each of {} angles", table.angle.size()));
    core::require_new_file(file, force);
    core::require_new_file(csv, force);
    profile::Profile changed = search::codesign::moved(loaded.value, fs::absolute(file).parent_path());
    changed.name = file.stem().string();
    changed.law.curves = profile::TablePair{csv.filename(), {}, {}, {}, {table.knots, table.smoothing}};
    changed.law.start_torque = table.start_torque;
    changed.law.end_torque = table.end_torque;
    core::make_folder(fs::absolute(file).parent_path());
    write_table(csv, table);
    try {
        LoadedProfile made = parsed(profile::to_toml(changed), file);
        core::write_file(file, made.toml);
        return made;
    } catch (...) {  // nothing half-written
        std::error_code none;
        fs::remove(csv, none);
        throw;
    }
}

void def_changes(py::class_<LoadedProfile>& type) {
    type.def("with_values", &with_values, py::arg("values"), py::arg("why") = "",
             "The profile with other values, each in the unit of its key; comments and order stay. `why` becomes a comment. Raises "
             "InvalidInput for an unknown key or a wrong value.")
        .def("write", &write, py::arg("file"), py::arg("force") = false,
             "Writes the profile and returns it as it is there; files that it names are reached from the new folder. Raises IoError if the "
             "file exists, unless `force`.")
        .def(
            "with_table",
            [](const LoadedProfile& loaded, const fs::path& file, const Numbers& angle, const Numbers& series, const Numbers& parallel,
               double start_torque, double end_torque, int knots, double smoothing, bool force) {
                return with_table(loaded, file, {angle, series, parallel, start_torque, end_torque, knots, smoothing}, force);
            },
            py::arg("file"), py::arg("angle"), py::arg("series"), py::arg("parallel"), py::kw_only(), py::arg("start_torque"),
            py::arg("end_torque"), py::arg("knots") = spring::TableOptions{}.knots, py::arg("smoothing") = spring::TableOptions{}.smoothing,
            py::arg("force") = false,
            "The profile with a measured law: capstan angles [rad] and the torques of both springs [Nm]. Writes `file` and, beside it, the "
            "rows as a CSV file, so that `fusee make` takes them too. See `tabulated` for knots and smoothing.");
}

}  // namespace

LoadedProfile profile_of(const py::object& given) {
    if (py::isinstance<LoadedProfile>(given)) return given.cast<LoadedProfile>();
    return read(path_of(given, "a Profile"));
}

fs::path path_of(const py::object& given, const std::string& or_else) {
    if (!py::isinstance<py::str>(given) && !py::hasattr(given, "__fspath__"))
        throw py::type_error(py::repr(given).cast<std::string>() + ": a path or " + or_else + " is expected");
    return given.cast<fs::path>();
}

void bind_profile(py::module_& module) {
    py::class_<LoadedProfile> type(module, "Profile", "A profile: all input of a design (docs/profile.md).");
    type.def(py::init(&read), py::arg("path"),
             "Reads a profile and the CSV files that it names (docs/profile.md lists every key). Raises IoError if a file is missing, too "
             "large or not TOML (line and column); InvalidInput naming file, line, column and key for an unknown, missing or wrong value.")
        .def_static("parse", &parsed, py::arg("toml"), py::arg("path"),
                    "A profile from a text. `path` is the file that the text would have: files that it names are searched beside it; it "
                    "need not exist. Raises InvalidInput and IoError, as the class does.")
        .def_property_readonly(
            "name", [](const LoadedProfile& p) { return p.value.name; }, doc("profile::Profile::name"))
        .def_property_readonly(
            "file", [](const LoadedProfile& p) { return p.value.file; }, doc("profile::Profile::file"))
        .def_property_readonly(
            "sha256", [](const LoadedProfile& p) { return p.value.sha256; }, doc("profile::Profile::sha256"))
        .def_property_readonly(
            "has_parts", [](const LoadedProfile& p) { return p.value.has_parts; },
            "False: the file describes no cams; the joint can be simulated but not made.")
        .def_readonly("toml", &LoadedProfile::toml, "The text that it was read from.")
        .def("__getitem__", &value_at, py::arg("key"), R"(The value of a key, "rig.gear_friction", in the unit at the key's end.)")
        .def("__repr__", [](const LoadedProfile& p) { return fmt::format("<Profile {} of {}>", p.value.name, p.value.file.string()); });
    def_changes(type);
    module.def("keys", &profile::key_names, doc("profile::key_names"));
}

}  // namespace fusee::python
