#include "fusee/diagnosis/next_case.h"

#include <algorithm>

#include "fusee/core/error.h"
#include "next_experiment_menu.h"

namespace fusee::diagnosis {

namespace {

/// The rows of a measurement of one kind, each as often as it is repeated.
template <typename Row, typename Number>
std::vector<Row> repeated(const std::vector<Row>& sheet, const Measurement& m, const Number& number) {
    std::vector<Row> rows;
    for (const std::size_t i : m.rows)
        for (int repeat = 1; repeat <= m.repeats; ++repeat) {
            rows.push_back(sheet[i]);
            number(rows.back(), repeat);
        }
    return rows;
}

gap_case::Rows rows_of(const Menu& menu, const Measurement& m) {
    const gap_case::Rows& sheet = menu.sheets[m.sheet];
    const auto unnumbered = [](const auto&, int) {};
    gap_case::Rows rows;
    switch (m.experiment) {
        case gap_case::Experiment::kBreakAway:
            rows.breakaway = repeated(sheet.breakaway, m, unnumbered);
            break;
        case gap_case::Experiment::kSpringPull:
            rows.spring_pull = repeated(sheet.spring_pull, m, unnumbered);
            break;
        case gap_case::Experiment::kDeadBand:
            rows.dead_band = repeated(sheet.dead_band, m, [](gap_case::DeadBandRow& row, int repeat) { row.repeat = repeat; });
            break;
        case gap_case::Experiment::kJointStiffness:
            rows.joint_stiffness = repeated(sheet.joint_stiffness, m, unnumbered);
            break;
        case gap_case::Experiment::kCocontraction:
            rows.cocontraction = repeated(sheet.cocontraction, m, unnumbered);
            break;
        case gap_case::Experiment::kLog:
            rows.log = repeated(sheet.log, m, unnumbered);
            break;
    }
    return rows;
}

/// Its sentence ends with the sentence of the measurement (none_tells puts words before it).
bool asks_for(const NextExperiment& next, const Measurement& m) {
    return next.experiment == to_string(m.experiment) && next.text.ends_with(sentence_of(m, next.information));
}

std::string purpose_of(const NextExperiment& next) {
    return "The diagnosis asks for this measurement: " + next.text + " Diagnose it with the earlier ones: copy " + next.experiment +
           ".csv into\nthe folder of the earlier case as " + next.experiment + "_next.csv, and name both in its case.toml, as in `" +
           next.experiment + " = [\"" + next.experiment + ".csv\", \"" + next.experiment + "_next.csv\"]`.\n\n";
}

}  // namespace

NextCase next_case(const gap_case::Case& measured, const Diagnosis& found, const std::string& file) {
    if (found.case_sha256 != measured.sha256)
        throw core::InvalidInput(file + ": case_sha256", found.case_sha256,
                                 measured.sha256 + ", that of the case " + measured.name + ": diagnose the case as it is now");
    if (found.next.empty())
        throw core::InvalidInput(file + ": next", "no measurement",
                                 "a diagnosis that asks for one: this one is " + std::string(to_string(found.verdict)));
    const NextExperiment& next = found.next.front();
    const Menu menu = measurement_menu(measured);
    const auto asked =
        std::find_if(menu.measurements.begin(), menu.measurements.end(), [&](const Measurement& m) { return asks_for(next, m); });
    if (asked == menu.measurements.end())
        throw core::InvalidInput(file + ": next", next.text, "a measurement of this version of fusee: diagnose the case again");
    NextCase made{template_of(measured), rows_of(menu, *asked), next};
    made.empty.purpose = purpose_of(next);
    return made;
}

}  // namespace fusee::diagnosis
