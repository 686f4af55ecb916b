#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "docs.h"
#include "fusee/core/finding.h"
#include "fusee/profile/profile.h"

/// import fusee: the pure functions of the modules, on NumPy arrays. One source for each area; module.cpp calls them in this order.
namespace fusee::python {

namespace py = pybind11;

void bind_errors(py::module_& module);
void bind_findings(py::module_& module);
void bind_profile(py::module_& module);
void bind_law(py::module_& module);
void bind_simulation(py::module_& module);
void bind_parts(py::module_& module);
void bind_make(py::module_& module);
void bind_search(py::module_& module);
void bind_fix(py::module_& module);
void bind_gap_case(py::module_& module);
void bind_simulator(py::module_& module);
void bind_diagnosis(py::module_& module);
void bind_commands(py::module_& module);

/// A profile with the text that it was read from: edits keep its comments.
struct LoadedProfile {
    profile::Profile value;
    std::string toml;
};
/// The profile of a path, or one that is loaded already. @throws TypeError of Python for anything else
[[nodiscard]] LoadedProfile profile_of(const py::object& given);
/// @throws TypeError of Python if it is no path
[[nodiscard]] std::filesystem::path path_of(const py::object& given, const std::string& or_else);

/// A dataclass of fusee.results from its fields; members of `fields` that it does not have are left out.
[[nodiscard]] inline py::object dataclass_of(const char* name, const py::dict& fields) {
    return py::module_::import("fusee.results").attr("result_of")(name, fields);
}

template <class Result>
[[nodiscard]] bool no_error(const Result& result) {
    return !core::any_error(result.findings);
}

}  // namespace fusee::python
