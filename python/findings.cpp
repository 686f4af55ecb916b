#include <map>

#include "bindings.h"

namespace fusee::python {

namespace {

std::vector<std::map<std::string, std::string>> changes_of(const core::Finding& finding) {
    std::vector<std::map<std::string, std::string>> alternatives;
    for (const core::Changes& changes : finding.suggestion.changes()) {
        alternatives.emplace_back();
        for (const core::Change& change : changes) alternatives.back()[change.key] = change.value;
    }
    return alternatives;
}

}  // namespace

void bind_findings(py::module_& module) {
    using core::Finding, core::Place, core::OverriddenLimit;
    py::class_<Place>(module, "Place", doc("core::Place"))
        .def_readonly("angle", &Place::angle, doc("core::Place::angle"))
        .def_readonly("point_mm", &Place::point_mm, doc("core::Place::point_mm"));
    py::class_<OverriddenLimit>(module, "OverriddenLimit", doc("core::OverriddenLimit"))
        .def_readonly("limit", &OverriddenLimit::limit, doc("core::OverriddenLimit::limit"))
        .def_readonly("value", &OverriddenLimit::value, doc("core::OverriddenLimit::value"))
        .def_readonly("normal", &OverriddenLimit::normal, doc("core::OverriddenLimit::normal"))
        .def_readonly("unit", &OverriddenLimit::unit, doc("core::OverriddenLimit::unit"))
        .def_readonly("reason", &OverriddenLimit::reason, doc("core::OverriddenLimit::reason"));
    py::class_<Finding>(module, "Finding", doc("core::Finding"))
        .def_readonly("rule", &Finding::rule, doc("core::Finding::rule"))
        .def_property_readonly(
            "severity", [](const Finding& f) { return core::to_string(f.severity); }, R"("pass", "not judged", "warning" or "error")")
        .def_readonly("what", &Finding::what, doc("core::Finding::what"))
        .def_readonly("measured", &Finding::measured, "In `unit`.")
        .def_property_readonly(
            "bound", [](const Finding& f) { return f.bound == core::Bound::kAtMost ? "at most" : "at least"; }, doc("core::Bound"))
        .def_readonly("allowed", &Finding::allowed, "In `unit`.")
        .def_readonly("unit", &Finding::unit, doc("core::Finding::unit"))
        .def_readonly("where", &Finding::where, doc("core::Finding::where"))
        .def_readonly("place", &Finding::place, "On the part; None: nowhere in particular.")
        .def_property_readonly(
            "suggestion", [](const Finding& f) { return f.suggestion.text(); }, doc("core::Finding::suggestion"))
        .def_property_readonly(
            "changes", &changes_of,
            "The alternatives of the suggestion, the best first: of each the keys that change together, with values as TOML.")
        .def_readonly("source", &Finding::source, doc("core::Finding::source"))
        .def_readonly("overridden", &Finding::overridden, doc("core::Finding::overridden"))
        .def("__repr__", [](const Finding& f) { return "<Finding " + core::to_line(f) + ">"; })
        .def("__str__", &core::to_line, doc("core::to_line"));
}

}  // namespace fusee::python
