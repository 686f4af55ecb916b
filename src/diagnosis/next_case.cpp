#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <type_traits>

#include "fusee/core/error.h"
#include "fusee/diagnosis/diagnose.h"
#include "fusee/effects/menu.h"
#include "next_experiment.h"

namespace fusee::diagnosis {

namespace {

/// The rows of a measurement alone, each as often as it is repeated.
gap_case::Rows rows_of(const effects::MeasurementMenu& menu, const effects::SheetMeasurement& m) {
    const gap_case::Rows& sheet = menu.sheets[m.sheet];
    gap_case::Rows rows;
    const auto take = [&](auto table) {
        for (const std::size_t i : m.rows)
            for (int repeat = 1; repeat <= m.repeats; ++repeat) {
                auto row = (sheet.*table)[i];
                if constexpr (std::is_same_v<decltype(row), gap_case::DeadBandRow>) row.repeat = repeat;
                (rows.*table).push_back(row);
            }
    };
    using gap_case::Experiment, gap_case::Rows;
    if (m.experiment == Experiment::kBreakAway) take(&Rows::breakaway);
    if (m.experiment == Experiment::kSpringPull) take(&Rows::spring_pull);
    if (m.experiment == Experiment::kDeadBand) take(&Rows::dead_band);
    if (m.experiment == Experiment::kJointStiffness) take(&Rows::joint_stiffness);
    if (m.experiment == Experiment::kCocontraction) take(&Rows::cocontraction);
    if (m.experiment == Experiment::kLog) take(&Rows::log);
    return rows;
}

/// Its sentence ends with the sentence of the measurement (none_tells puts words before it).
bool asks_for(const NextExperiment& next, const effects::SheetMeasurement& m) {
    return next.experiment == to_string(m.experiment) && next.text.ends_with(sentence_of(m.offer(), next.information));
}

/// What to measure, and how the new file joins those of the case.
std::string purpose_of(const gap_case::Case& measured, const effects::SheetMeasurement& m, const std::string& text) {
    const std::string name = to_string(m.experiment), file = name + "_next.csv";
    std::vector<std::string> files{file};
    if (const auto earlier = measured.files.find(m.experiment); earlier != measured.files.end())
        files.insert(files.begin(), earlier->second.begin(), earlier->second.end());
    std::string purpose = fmt::format(
        "The diagnosis asks for this measurement: {} To diagnose it with the earlier ones, copy\n{}.csv into the folder of the earlier "
        "case as "
        "{}, and write `{} = [\"{}\"]` into the table\n`[experiments]` of its case.toml.",
        text, name, file, name, fmt::join(files, "\", \""));
    if (measured.columns.contains(m.experiment))
        purpose += fmt::format(" `[columns.{}]` of that case holds for the new file too: give it the same header.", name);
    return purpose + "\n\n";
}

}  // namespace

NextCase next_case(const gap_case::Case& measured, const Diagnosis& found, const std::string& file) {
    if (found.case_sha256 != measured.sha256)
        throw core::InvalidInput(file + ": case_sha256", found.case_sha256,
                                 measured.sha256 + ", that of the case " + measured.name + ": diagnose the case as it is now");
    if (found.next.empty())
        throw core::InvalidInput(file + ": next", "no measurement is asked for: the verdict is " + std::string(to_string(found.verdict)),
                                 "a diagnosis with a next measurement");
    const NextExperiment& next = found.next.front();
    const effects::MeasurementMenu menu = effects::measurement_menu(measured);
    const auto asked = std::find_if(menu.measurements.begin(), menu.measurements.end(),
                                    [&](const effects::SheetMeasurement& m) { return asks_for(next, m); });
    if (asked == menu.measurements.end())
        throw core::InvalidInput(file + ": next", next.text, "a measurement of this version of fusee: diagnose the case again");
    NextCase made{effects::template_of(measured), rows_of(menu, *asked), next};
    made.empty.purpose = purpose_of(measured, *asked, next.text);
    return made;
}

}  // namespace fusee::diagnosis
