#include <fmt/format.h>
#include <fmt/ranges.h>

#include "arrays.h"
#include "fusee/batch/batch.h"
#include "fusee/checks/limits.h"
#include "fusee/pipeline/check.h"
#include "fusee/profile/places.h"
#include "fusee/report/headline.h"
#include "html.h"
#include "results.h"
#include "work.h"

namespace fs = std::filesystem;

namespace fusee::python {

namespace {

/// A made design, or why it cannot be made.
struct Made {
    std::shared_ptr<const pipeline::MadeDesign> value;  ///< null: refused
    core::Findings findings;
    fs::path folder;  ///< empty: nothing was written
};

Made in_memory(const profile::Profile& profile) {
    auto made = pipeline::make_figures(profile);
    if (!made) return {nullptr, made.refusal(), {}};
    core::Findings findings = made->report.all_findings();
    return {std::make_shared<const pipeline::MadeDesign>(std::move(made).value()), std::move(findings), {}};
}

Made in_folder(const profile::Profile& profile, const batch::OutFolder& folder, const pipeline::MakeOptions& options) {
    Made made;
    batch::MakeResult result = batch::make(profile, folder, options);
    if (result.design) made.value = std::make_shared<const pipeline::MadeDesign>(*std::move(result.design));
    made.findings = std::move(result.findings);
    made.folder = std::move(result.folder);
    return made;
}

pipeline::Via via_of(const std::string& word) {
    if (word == "cgal") return pipeline::Via::kCgal;
    if (word == "openscad") return pipeline::Via::kOpenScad;
    throw core::InvalidInput("via", word, "cgal or openscad");
}

Made make(const py::object& given, const std::optional<fs::path>& out, const std::string& via, bool force, const py::object& progress) {
    const LoadedProfile loaded = profile_of(given);
    const pipeline::Via kernel = via_of(via);
    return run(progress, [&](Watch& watch) {
        return profile::with_places(loaded.value, [&] {
            if (!out) return in_memory(loaded.value);
            const auto note = [&watch](const std::string& what) { watch.tell(what); };
            return in_folder(loaded.value, {.out = *out, .force = force}, {.via = kernel, .note = note});
        });
    });
}

std::vector<PartResult> parts_of(const Made& made) {
    std::vector<PartResult> parts;
    if (!made.value) return parts;
    const pipeline::DesignReport& report = made.value->report;
    for (const auto* side : {&report.parts, &report.mirrored})
        for (const pipeline::PartReport& one : *side)
            parts.push_back({one.name, one.part, one.findings, report.provenance.line(), made.value->resolved.profile.process});
    return parts;
}

std::optional<LawCurve> law_of(const Made& made) {
    if (!made.value) return std::nullopt;
    return LawCurve{std::make_shared<std::vector<spring::LawPoint>>(spring::sample_by_load(*made.value->resolved.law(), 401))};
}

double figure(const Made& made, double pipeline::FileErrors::*member) {
    return made.value ? made.value->report.file_errors().*member : core::kNan;
}

void bind_made(py::module_& module) {
    py::class_<Made>(module, "Made", "A design as made: its parts, figures and findings.")
        .def_property_readonly(
            "ok", [](const Made& m) { return m.value != nullptr && no_error(m); }, "Can it be made, and does every file carry the law?")
        .def_readonly("findings", &Made::findings, "Of every rule, passes too; if it cannot be made, the limits that bind.")
        .def_property_readonly(
            "folder", [](const Made& m) { return m.folder.empty() ? std::nullopt : std::optional(m.folder); },
            "The folder of its files; None: nothing was written.")
        .def_property_readonly("parts", &parts_of,
                               "K_SE, K_PE and, with files, their mirror images; of one spring its part, \"cam\", "
                               "of two cables also \"cam_back\".")
        .def_property_readonly("law", &law_of, "The law as designed at 401 loads, lead-in included; of one spring at 401 angles.")
        .def_property_readonly(
            "arm_error", [](const Made& m) { return figure(m, &pipeline::FileErrors::arm); }, doc("pipeline::FileErrors::arm"))
        .def_property_readonly(
            "dead_band_error", [](const Made& m) { return figure(m, &pipeline::FileErrors::dead_band); },
            doc("pipeline::FileErrors::dead_band"))
        .def("_repr_html_",
             [](const Made& m) {
                 if (!m.value) return html_of("Cannot be made", {}, m.findings);
                 const pipeline::DesignReport& report = m.value->report;
                 std::vector<std::pair<std::string, std::string>> figures;
                 for (const report::HeadFigure& figure : report::head_figures(report.headline, report.file_errors()))
                     figures.emplace_back(figure.value, figure.label);
                 return html_of(report.provenance.name, figures, m.findings);
             })
        .def("__repr__", [](const Made& m) {
            return m.value
                       ? fmt::format("<Made {} in {}>", m.value->report.provenance.name, m.folder.empty() ? "memory" : m.folder.string())
                       : fmt::format("<Made refused: {} findings>", m.findings.size());
        });
    module.def("make", &make, py::arg("profile"), py::arg("out") = py::none(), py::kw_only(), py::arg("via") = "cgal",
               py::arg("force") = false, py::arg("progress") = py::none(),
               "Makes the cams of a profile. With `out`, a folder: all files of `fusee make` in out/NAME, read back; a design with errors "
               "writes nothing. Without it: the parts and the rules, no file, the agonist's side. `progress` is called with a text when "
               "something long begins. Raises InvalidInput and IoError; a design that cannot be made raises nothing.");
}

std::vector<checks::ProcessKind> kinds_of(const profile::Profile& profile, const std::vector<std::string>& words) {
    std::vector<checks::ProcessKind> kinds;
    std::vector<std::string> known;
    for (const checks::ProcessLimits& row : checks::process_table()) known.emplace_back(checks::to_string(row.kind));
    for (const std::string& word : words) {
        const auto found = std::find(known.begin(), known.end(), word);
        if (found == known.end()) throw core::InvalidInput("processes", word, fmt::format("{}", fmt::join(known, ", ")));
        kinds.push_back(checks::process_table()[static_cast<std::size_t>(found - known.begin())].kind);
    }
    return kinds.empty() ? std::vector{profile.process.kind} : kinds;
}

pipeline::Checked check(const py::object& given, const std::vector<std::string>& processes) {
    const LoadedProfile loaded = profile_of(given);
    const auto kinds = kinds_of(loaded.value, processes);
    return run(py::none(),
               [&](Watch&) { return profile::with_places(loaded.value, [&] { return pipeline::check(loaded.value, kinds); }); });
}

void bind_checked(py::module_& module) {
    using pipeline::Checked, pipeline::CheckedProcess, pipeline::CheckedPart;
    py::class_<CheckedPart>(module, "CheckedPart", doc("pipeline::CheckedPart"))
        .def_readonly("name", &CheckedPart::name, doc("pipeline::CheckedPart::name"))
        .def_readonly("findings", &CheckedPart::findings, "Of every rule on this part.");
    py::class_<CheckedProcess>(module, "CheckedProcess", doc("pipeline::CheckedProcess"))
        .def_readonly("process", &CheckedProcess::process, "Its name, \"fdm\".")
        .def_readonly("figures", &CheckedProcess::figures, "Where its limits come from, and which it does not have.")
        .def_readonly("parts", &CheckedProcess::parts, "K_SE and K_PE.")
        .def_property_readonly("findings", &CheckedProcess::all, "Of the design and of each part.")
        .def_property_readonly(
            "ok", [](const CheckedProcess& p) { return !core::any_error(p.all()); }, "Can this process make every part?");
    py::class_<Checked>(module, "Checked", doc("pipeline::Checked"))
        .def_readonly("name", &Checked::name, doc("pipeline::Checked::name"))
        .def_property_readonly("ok", &Checked::makeable, doc("pipeline::Checked::makeable"))
        .def_readonly("processes", &Checked::processes, "One for each process that was asked for.")
        .def("_repr_html_",
             [](const Checked& c) {
                 std::string text;
                 for (const CheckedProcess& process : c.processes) text += html_of(c.name + " by " + process.process, {}, process.all());
                 return text;
             })
        .def("__repr__", [](const Checked& c) { return fmt::format("<Checked {}: {}>", c.name, c.makeable() ? "can be made" : "errors"); });
    module.def("check", &check, py::arg("profile"), py::arg("processes") = std::vector<std::string>{},
               "Law, cams, solids and rules for each process (\"fdm\", \"mill\", ...; none: the profile's own), without files: the "
               "findings of `make` before it exports. Raises InvalidInput and IoError for a profile that cannot be read.");
}

}  // namespace

void bind_make(py::module_& module) {
    bind_made(module);
    bind_checked(module);
}

}  // namespace fusee::python
