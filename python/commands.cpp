#include <fmt/format.h>

#include <chrono>

#include "arrays.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/drawing/sheet.h"
#include "fusee/gap_case/break_away.h"
#include "fusee/mjcf/write.h"
#include "fusee/pipeline/budget.h"
#include "fusee/pipeline/coupons.h"
#include "fusee/pipeline/make.h"
#include "fusee/pipeline/rig.h"
#include "fusee/pipeline/springs.h"
#include "fusee/profile/edit.h"
#include "fusee/profile/places.h"
#include "fusee/report/budget.h"
#include "fusee/report/calibration.h"
#include "fusee/report/identification.h"
#include "fusee/report/picture.h"
#include "fusee/report/search.h"
#include "fusee/search/one_spring.h"
#include "fusee/study/store.h"
#include "results.h"
#include "work.h"

namespace fs = std::filesystem;

/// Commands of the program whose result is a table or a file.
namespace fusee::python {

namespace {

py::dict dict_of(const std::string& json) { return py::module_::import("json").attr("loads")(json); }

/// The value, or an exception that says why a profile's springs or cams do not exist.
template <class Value>
Value value_or_raise(core::Outcome<Value> outcome) {
    if (!outcome) throw core::InvalidInput("profile", "refused", core::to_line(outcome.refusal().front()));
    return std::move(outcome).value();
}

py::object budget(const py::object& given, int draws, double wanted_percent) {
    const LoadedProfile loaded = profile_of(given);
    const profile::Profile& profile = loaded.value;
    const std::string json = run(py::none(), [&](Watch&) {
        return profile::with_places(profile, [&] {
            const design::budget::Budget found = value_or_raise(pipeline::find_budget(profile, draws));
            return report::budget_json({profile.name, checks::to_string(profile.process.kind)}, found, 0.01 * wanted_percent);
        });
    });
    return dataclass_of("Budget", dict_of(json));
}

/// Name of the spring and the keys that put it into the profile.
py::list springs_list(cam::PartKind part, const std::vector<pipeline::FoundSpring>& found, const profile::Profile& profile) {
    const py::object loads = py::module_::import("tomllib").attr("loads");
    py::list springs;
    for (const pipeline::FoundSpring& spring : found) {
        py::dict values, one;
        for (const profile::Edit& edit : pipeline::spring_edits(part, spring, profile))
            values[edit.key.c_str()] = loads("value = " + edit.value)["value"];
        one["name"] = spring.name;
        one["values"] = values;
        springs.append(one);
    }
    return springs;
}

py::dict springs(const py::object& given, const std::optional<fs::path>& catalogue, double within_percent, std::size_t most,
                 bool accept_reviews) {
    const LoadedProfile loaded = profile_of(given);
    pipeline::SpringSearchOptions options;
    options.within = 0.01 * within_percent;
    options.most = most;
    options.accept_reviews = accept_reviews;
    const spring::Catalogue on_sale = catalogue ? spring::read_catalogue(*catalogue, {}) : loaded.value.co_design.catalogue;
    const auto searches = run(py::none(), [&](Watch&) {
        return profile::with_places(loaded.value, [&] {
            pipeline::require_parts(loaded.value);
            const auto design = value_or_raise(pipeline::resolve(loaded.value));
            std::vector<pipeline::SpringSearch> found;
            for (const cam::PartKind kind : loaded.value.part_kinds())
                found.push_back(value_or_raise(pipeline::find_springs(kind, design, on_sale, options)));
            return found;
        });
    });
    py::dict parts;
    for (const pipeline::SpringSearch& search : searches) {
        py::dict found, broken;
        found["wound"] = springs_list(search.part, search.wound, loaded.value);
        found["bought"] = springs_list(search.part, search.bought, loaded.value);
        found["tried"] = search.tried;
        for (const auto& [rule, count] : search.broken) broken[rule.c_str()] = count;
        found["broken"] = broken;
        parts[py::str(search.table)] = dataclass_of("PartSprings", found);
    }
    return parts;
}

/// Each family of a single spring with its smallest part, as `fusee design`.
py::dict smallest_parts(const py::object& given, const std::optional<fs::path>& catalogue, bool repair, std::optional<int> generations,
                        unsigned jobs, const py::object& progress) {
    const LoadedProfile loaded = profile_of(given);
    const auto families = run(progress, [&](Watch& watch) {
        return profile::with_places(loaded.value, [&] {
            if (!loaded.value.is_spring())
                throw core::InvalidInput("kind", "joint", "\"spring\"; of a joint fusee.design searches springs");
            pipeline::require_parts(loaded.value);
            search::one_spring::Options options{.repair = repair, .jobs = jobs, .stop = [&watch] { return watch.stopped(); }};
            options.progress = [&watch](const std::string& family) { watch.tell(family); };
            if (generations) options.generations = *generations;
            if (catalogue) options.catalogue = spring::read_catalogue(*catalogue);
            return search::one_spring::find_smallest(loaded.value, options);
        });
    });
    const py::list figures = py::module_::import("json").attr("loads")(report::families_json(families));
    py::dict parts;
    for (std::size_t i = 0; i < families.size(); ++i) {
        py::dict one;
        one["profile"] = families[i].found()
                             ? py::cast(LoadedProfile{*families[i].profile, profile::to_commented_toml(*families[i].profile)})
                             : py::object(py::none());
        one["figures"] = figures[i];
        one["figures"].attr("pop")("findings");
        one["findings"] = families[i].findings;
        parts[families[i].name.c_str()] = dataclass_of("SmallestPart", one);
    }
    return parts;
}

py::object identify(const fs::path& csv, const std::vector<std::string>& columns) {
    const std::string bytes = core::read_file(csv, gap_case::kLargestBreakAwayFile);
    const auto rows = gap_case::parse_break_away(bytes, csv.string(), core::CsvMapping::of(columns));
    return dataclass_of(
        "Identification",
        dict_of(report::identification_json({csv.stem().string(), core::sha256_hex(bytes), gap_case::identify_friction(rows)})));
}

py::object calibrate(const fs::path& sheet, const py::object& profile, const std::optional<fs::path>& write, bool force) {
    constexpr std::size_t kLargestSheet = 10'000'000;  // bytes
    if (write && profile.is_none()) throw core::InvalidInput("profile", "None", "the profile of the coupons, together with `write`");
    if (write) core::require_new_file(*write, force);
    const std::optional<LoadedProfile> loaded = profile.is_none() ? std::nullopt : std::optional(profile_of(profile));
    if (loaded) profile::with_places(loaded->value, [&] { pipeline::require_parts(loaded->value); });
    const coupon::Present present = loaded ? pipeline::present_of(loaded->value) : coupon::Present{};
    const std::string bytes = core::read_file(sheet, kLargestSheet), file = sheet.string();
    pipeline::CalibrationReport found{sheet.stem().string(), core::sha256_hex(bytes), {}};
    std::string corrected;
    if (coupon::is_inspection(bytes, {})) {
        const coupon::InspectionSheet rows = coupon::parse_inspection(bytes, file, {});
        found.calibration = coupon::inspect_contour(rows, present);
        if (write) corrected = pipeline::inspected_profile(loaded->value, loaded->toml, rows, found.calibration, *write);
    } else {
        const coupon::Sheet rows = coupon::parse_sheet(bytes, file, {});
        found.calibration = coupon::calibrate(rows, present, file);
        if (write) corrected = pipeline::calibrated_profile(loaded->value, loaded->toml, rows, found.calibration, *write);
    }
    if (write) core::write_file(*write, corrected);
    py::dict figures = dict_of(report::calibration_json(found));
    figures["findings"] = found.calibration.findings;
    return dataclass_of("Calibration", figures);
}

void render(const py::object& given, const fs::path& file, const std::string& view, int width_px, bool dark, bool force) {
    const std::string ending = file.extension().string();
    if (ending != ".svg" && ending != ".png") throw core::InvalidInput("file", file.string(), "a file name that ends in .svg or .png");
    core::require_new_file(file, force);
    LoadedProfile loaded = profile_of(given);
    loaded.value.outputs.formats = {"stl"};
    run(py::none(), [&](Watch&) {
        profile::with_places(loaded.value, [&] {
            pipeline::require_parts(loaded.value);
            const core::TemporaryFolder folder;
            core::OutputFolder parts(folder.path() / "parts", {.command = "make", .source = loaded.value.file});  // never committed
            const auto design = value_or_raise(pipeline::make_parts(loaded.value, parts));
            report::PictureOptions options;
            options.theme = dark ? report::Theme::kDark : report::Theme::kLight;
            options.longest_px = width_px;
            const std::string svg = report::design_picture(design.report, view, options);
            core::write_file(file, ending == ".png" ? drawing::png_of_svg(svg, file.string(), width_px) : svg);
        });
        return 0;
    });
}

/// Numbers where every cell is one or empty (NaN), else texts.
py::object column_of(const std::vector<std::string>& cells) {
    py::array_t<double> values(static_cast<py::ssize_t>(cells.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) {
        char* end = nullptr;
        values.mutable_data()[i] = cells[i].empty() ? core::kNan : std::strtod(cells[i].c_str(), &end);
        if (!cells[i].empty() && *end != '\0') return py::module_::import("numpy").attr("array")(cells);
    }
    return values;
}

py::dict query(const fs::path& study, const std::string& sql, unsigned seconds) {
    const fs::path file = fs::is_directory(study) ? study / "index.sqlite" : study;
    std::vector<std::string> names;
    std::vector<std::vector<std::string>> columns;
    study::query(file, sql, std::chrono::seconds(seconds), [&](const std::vector<std::string>& cells) {
        if (names.empty()) {
            names = cells;
            columns.resize(cells.size());
            return true;
        }
        for (std::size_t i = 0; i < cells.size(); ++i) columns[i].push_back(cells[i]);
        return true;
    });
    py::dict table;
    for (std::size_t i = 0; i < names.size(); ++i) table[names[i].c_str()] = column_of(columns[i]);
    return table;
}

void write_mjcf(const py::object& given, const fs::path& folder, bool force) {
    const LoadedProfile loaded = profile_of(given);
    core::OutputFolder output(folder, {.command = "simulate",
                                       .source = loaded.value.file,
                                       .force = force,
                                       .files = {mjcf::kModelFile, mjcf::kLawsFile, mjcf::kJavaScriptFile, mjcf::kPythonFile}});
    profile::with_places(loaded.value, [&] {
        mjcf::write(pipeline::twin_of(value_or_raise(pipeline::resolve(loaded.value))), output.path());
        output.commit();
    });
}

void bind_tables(py::module_& module) {
    module.def(
        "budget", &budget, py::arg("profile"), py::kw_only(), py::arg("draws") = 1000, py::arg("wanted_percent") = 5.0,
        "The errors of joints as a shop builds them, by source, and the tolerances for a torque error of +-`wanted_percent`. `draws` "
        "joints are sampled; a single spring is computed to first order. Raises InvalidInput, also if a cam cannot be designed.");
    module.def("springs", &springs, py::arg("profile"), py::arg("catalogue") = py::none(), py::kw_only(), py::arg("within_percent") = 2.0,
               py::arg("most") = 5, py::arg("accept_reviews") = false,
               "Springs that can be wound or bought, by part (\"k_se\" and \"k_pe\"), each with the `values` that Profile.with_values puts "
               "into the profile. `catalogue` is a CSV file of springs on sale; "
               "a wound spring's rate differs by `within_percent` at most. Raises InvalidInput and IoError.");
    module.def("smallest_parts", &smallest_parts, py::arg("profile"), py::kw_only(), py::arg("catalogue") = py::none(),
               py::arg("repair") = false, py::arg("generations") = py::none(), py::arg("jobs") = 0, py::arg("progress") = py::none(),
               "The smallest part of each family for a profile of one spring, by family, as `fusee design`. `catalogue` is a CSV file of "
               "springs on sale; with `repair` a law that cannot be made is changed. `progress` is called with the family's name. "
               "Raises InvalidInput and IoError; a family without a part has findings.");
    module.def("identify", &identify, py::arg("csv"), py::kw_only(), py::arg("columns") = std::vector<std::string>{},
               "Gear friction from break-away tests (docs/guides/identify-friction.md). The file has the columns side, direction, "
               "motor_torque_Nm and load_torque_Nm; `columns` names other headers, as "
               "\"load_torque_Nm=Last in mNm\". Raises InvalidInput naming file, line and column, and IoError.");
    module.def(
        "query", &query, py::arg("study"), py::arg("sql"), py::kw_only(), py::arg("seconds") = 60,
        "One SELECT on the index of a study (a folder of `fusee batch`): columns by name, numbers as an array of floats with NaN for "
        "empty cells, other columns as an array of texts; pandas.DataFrame takes it. Raises InvalidInput for a statement that is "
        "wrong, writes or runs longer than `seconds`; IoError if there is no index.");
}

}  // namespace

void bind_commands(py::module_& module) {
    bind_tables(module);
    module.def("calibrate", &calibrate, py::arg("sheet"), py::arg("profile") = py::none(), py::kw_only(), py::arg("write") = py::none(),
               py::arg("force") = false,
               "What measured coupons, or a filled inspection sheet, say, in SI. With `profile` the values are compared with the "
               "profile's; with `write` the calibrated profile becomes that file. Raises InvalidInput and "
               "IoError.");
    module.def(
        "render", &render, py::arg("profile"), py::arg("file"), py::arg("view") = "assembly", py::kw_only(), py::arg("width_px") = 1200,
        py::arg("dark") = false, py::arg("force") = false,
        "Draws one view of a design, such as \"cams\", \"assembly\" or \"dead-band\" (`fusee render --help` lists them), as *.svg or "
        "*.png of `width_px` pixels. Raises InvalidInput, also if the parts cannot be made, and IoError.");
    module.def("write_mjcf", &write_mjcf, py::arg("profile"), py::arg("folder"), py::kw_only(), py::arg("force") = false,
               "Writes the joint as designed as a model for MuJoCo: joint.xml, and laws.json with companion programs that apply the exact "
               "laws. Raises InvalidInput for an arrangement other than \"pnrvsa\", and IoError.");
}

}  // namespace fusee::python
