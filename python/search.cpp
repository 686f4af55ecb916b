#include "fusee/report/search.h"

#include <fmt/format.h>

#include <map>

#include "arrays.h"
#include "fusee/profile/places.h"
#include "fusee/search/design.h"
#include "results.h"
#include "work.h"

namespace fs = std::filesystem;

namespace fusee::python {

namespace {

/// What a search found.
struct Search {
    std::shared_ptr<const search::codesign::RunResult> value;  ///< never null
    fs::path folder;                                           ///< of its files; empty: nothing was written
    fs::path place;                                            ///< the folder from which the found profiles reach their files
};

struct SearchArguments {
    search::codesign::SearchChanges changes;
    std::optional<fs::path> out;
    unsigned jobs;
    bool resume, force;
};

Search in_folder(const profile::Profile& profile, search::codesign::RunOptions options, const fs::path& out) {
    options.out = out;
    core::OutputFolder output(options.out, search::codesign::result_folder(profile, options).filename(),
                              search::codesign::output_run(profile, options));
    Search search{
        std::make_shared<const search::codesign::RunResult>(search::codesign::find_springs(profile, options)), {}, output.target()};
    if (!search.value->found() || search.value->interrupted) return search;
    report::write_search(*search.value, output.path());
    output.commit();
    search.folder = output.target();
    return search;
}

Search find(const profile::Profile& profile, const SearchArguments& arguments, Watch& watch) {
    search::codesign::RunOptions options;
    options.out.clear();
    options.jobs = arguments.jobs;
    options.resume = arguments.resume;
    options.force = arguments.force;
    options.progress = [&watch](int generation, double best) { watch.tell(generation, best); };
    options.stop = [&watch] { return watch.stopped(); };
    if (arguments.out) return in_folder(profile, options, *arguments.out);
    const fs::path place = search::codesign::result_folder(profile, options);
    return {std::make_shared<const search::codesign::RunResult>(search::codesign::find_springs(profile, options)), {}, place};
}

Search design(const py::object& given, const SearchArguments& arguments, const py::object& progress) {
    LoadedProfile loaded = profile_of(given);
    if (loaded.value.is_spring())
        throw core::InvalidInput("kind", "spring", "\"joint\" for a search of its springs; fusee.smallest_parts searches one spring's");
    search::codesign::change_search(loaded.value.search, arguments.changes);
    return run(progress,
               [&](Watch& watch) { return profile::with_places(loaded.value, [&] { return find(loaded.value, arguments, watch); }); });
}

std::map<std::string, LoadedProfile> profiles_of(const Search& search) {
    std::map<std::string, LoadedProfile> profiles;
    for (const search::codesign::FoundProfile& found : search.value->profiles)
        profiles.emplace(found.file.string(), LoadedProfile{profile::parse_profile(found.toml, search.place / found.file), found.toml});
    return profiles;
}

core::Findings findings_of(const Search& search) {
    core::Findings findings = search.value->findings;
    if (search.value->search) core::append(findings, search.value->search->findings);
    return findings;
}

py::array_t<double> history_of(const Search& s) {
    static const std::vector<double> kNone;
    return numbers(s.value, s.value->search ? s.value->search->history : kNone);
}

std::optional<LawCurve> curve_of(const Search& s, search::codesign::LawCurves search::codesign::SearchReport::*which) {
    if (!s.value->search) return std::nullopt;
    return LawCurve{std::shared_ptr<const std::vector<spring::LawPoint>>(s.value, &((*s.value->search).*which).samples)};
}

void bind_figures(py::module_& module) {
    using search::codesign::ComparedFigure, search::codesign::ParetoPoint;
    py::class_<ComparedFigure>(module, "ComparedFigure", doc("search::codesign::ComparedFigure"))
        .def_readonly("name", &ComparedFigure::name, "What was compared.")
        .def_readonly("unit", &ComparedFigure::unit, "Of `found` and `own`.")
        .def_readonly("found", &ComparedFigure::found, "Of the design found.")
        .def_readonly("own", &ComparedFigure::own, "Of the profile's own design; NaN: it has none.")
        .def("__repr__", [](const ComparedFigure& f) { return fmt::format("<{}: {:g}, was {:g} {}>", f.name, f.found, f.own, f.unit); });
    py::class_<ParetoPoint>(module, "ParetoPoint", doc("search::codesign::ParetoPoint"))
        .def_readonly("file", &ParetoPoint::file, "Its profile, \"pareto/03.toml\".")
        .def_readonly("figure", &ParetoPoint::figure, doc("search::codesign::ParetoPoint::figure"))
        .def_readonly("travel", &ParetoPoint::travel, doc("search::codesign::ParetoPoint::travel"))
        .def_readonly("radius", &ParetoPoint::radius, doc("search::codesign::ParetoPoint::radius"))
        .def_readonly("limited_by", &ParetoPoint::limited_by, doc("search::codesign::ParetoPoint::limited_by"));
}

}  // namespace

void bind_search(py::module_& module) {
    bind_figures(module);
    py::class_<Search>(module, "Search", "What a search for springs found.")
        .def_property_readonly(
            "ok", [](const Search& s) { return s.value->found(); }, "Were springs found?")
        .def_property_readonly("findings", &findings_of,
                               "Nothing found: the limits that bind; else what has to be known beside the figures.")
        .def_property_readonly(
            "summary", [](const Search& s) { return s.value->summary; }, "The same in sentences.")
        .def_property_readonly("profiles", &profiles_of, R"(The profiles found by their files' names: "NAME-best.toml", "pareto/03.toml".)")
        .def_property_readonly(
            "folder", [](const Search& s) { return s.folder.empty() ? std::nullopt : std::optional(s.folder); },
            "The folder of its files; None: nothing was written.")
        .def_property_readonly("history", &history_of, doc("search::codesign::SearchReport::history"))
        .def_property_readonly(
            "law", [](const Search& s) { return curve_of(s, &search::codesign::SearchReport::found); },
            "The law found; None for a Pareto front.")
        .def_property_readonly(
            "own_law", [](const Search& s) { return curve_of(s, &search::codesign::SearchReport::own); }, "The profile's own law.")
        .def_property_readonly(
            "figures",
            [](const Search& s) { return s.value->search ? s.value->search->figures : std::vector<search::codesign::ComparedFigure>{}; },
            "Of the design found, beside those of the profile's own design.")
        .def_property_readonly(
            "front",
            [](const Search& s) { return s.value->pareto ? s.value->pareto->points : std::vector<search::codesign::ParetoPoint>{}; },
            doc("search::codesign::ParetoReport::points"))
        .def("__repr__", [](const Search& s) {
            return fmt::format("<Search: {}>", s.value->summary.empty() ? "nothing found" : s.value->summary.front());
        });
    module.def(
        "design",
        [](const py::object& profile, std::optional<std::string> method, std::optional<int> population, std::optional<int> generations,
           std::optional<int> seed, std::optional<fs::path> out, unsigned jobs, bool resume, bool force, const py::object& progress) {
            return design(profile, {{std::move(method), population, generations, seed}, std::move(out), jobs, resume, force}, progress);
        },
        py::arg("profile"), py::kw_only(), py::arg("method") = py::none(), py::arg("population") = py::none(),
        py::arg("generations") = py::none(), py::arg("seed") = py::none(), py::arg("out") = py::none(), py::arg("jobs") = 0,
        py::arg("resume") = false, py::arg("force") = false, py::arg("progress") = py::none(),
        "Searches springs for the joint of a profile, by \"algorithm_1\", \"co_design\" or \"pareto\"; None: as the profile says, like the "
        "other numbers. With `out`, a folder: the files of `fusee design` in out/NAME-design, with a checkpoint. `progress` is called with "
        "generation and best cost. Raises InvalidInput and IoError; springs that do not exist are findings.");
}

}  // namespace fusee::python
