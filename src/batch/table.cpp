#include <fmt/format.h>

#include <algorithm>

#include "fusee/batch/batch.h"
#include "fusee/core/lists.h"
#include "fusee/core/text.h"
#include "fusee/report/headline.h"
#include "fusee/report/rule_counts.h"
#include "fusee/report/simulation.h"

namespace fusee::batch {

const char* to_string(Outcome outcome) {
    switch (outcome) {
        case Outcome::kMade:
            return "made";
        case Outcome::kRefused:
            return "refused";
        case Outcome::kBadInput:
            return "bad input";
        case Outcome::kOutOfResources:
            return "out of resources";
        case Outcome::kFailed:
            return "failed";
        case Outcome::kInterrupted:
            return "stopped";
    }
    return "";
}

int exit_code(Outcome outcome) {
    switch (outcome) {
        case Outcome::kMade:
            return 0;
        case Outcome::kRefused:
            return 1;
        case Outcome::kBadInput:
        case Outcome::kOutOfResources:
            return 2;
        case Outcome::kFailed:
            return 3;
        case Outcome::kInterrupted:
            return 130;
    }
    return 3;
}

namespace {

std::string made_line(const Row& row) {
    const core::Findings& findings = row.result.findings;
    const std::string open = report::not_judged_text(findings);
    const std::size_t warnings = core::count(findings, core::Severity::kWarning);
    return fmt::format(
        "{}/  {} passed, {}{}{}", core::printable(row.result.folder.string()),
        core::counted(core::count(findings, core::Severity::kPass), "rule"), core::counted(warnings, "warning"),
        warnings > 0 ? " (review and accept)" : "",
        open.empty() ? "" : fmt::format("; {} (`fusee check {}` lists what is missing)", open, core::printable(row.profile.string())));
}

/// The headline, one figure a line.
std::string head_lines(const Row& row) {
    std::string lines;
    for (const report::HeadFigure& figure : report::head_figures(row.result.headline, row.result.file_errors))
        lines += fmt::format("    {}  {}\n", figure.value, figure.label);
    return lines;
}

/// The error or the binding findings, under a row.
std::string details(const Ended& row, const core::Findings& findings) {
    std::string lines;
    for (const std::string& line : core::pieces_of<std::string>(row.error, "\n")) lines += "    " + line + "\n";
    if (!lines.empty()) return lines;
    for (const core::Severity severity : {core::Severity::kError, core::Severity::kWarning})
        for (const core::Finding& f : findings)
            if (f.severity == severity) lines += "    " + core::to_line(f) + "\n";
    return lines;
}

/// "profiles/pnrvsa.toml  made         1.20 s  "; `done` is the word for success.
template <class AnyRow>
std::string beginning(const AnyRow& row, const std::vector<AnyRow>& rows, const char* done) {
    std::size_t width = 0;
    for (const Ended& other : rows) width = std::max(width, core::printable(other.profile.string()).size());
    return fmt::format("{:{}}  {:9}  {:6.2f} s  ", core::printable(row.profile.string()), width,
                       row.outcome == Outcome::kMade ? done : to_string(row.outcome), row.seconds);
}

}  // namespace

std::string closing_table(const std::vector<Row>& rows) {
    std::string table;
    for (const Row& row : rows) {
        table += beginning(row, rows, "made") + (row.outcome == Outcome::kMade ? made_line(row) : "") + "\n";
        if (row.outcome == Outcome::kMade) table += head_lines(row);
        table += details(row, row.result.findings);
    }
    return table;
}

std::string closing_table(const std::vector<SimulationRow>& rows) {
    std::string table;
    std::vector<pipeline::Simulation> done;
    for (const SimulationRow& row : rows) {
        table += beginning(row, rows, "simulated") + (row.simulation ? row.folder.string() + "/" : "") + "\n" + details(row, row.refusal);
        if (!row.simulation) continue;
        table += report::simulation_text(*row.simulation);
        if (!row.mjcf.empty()) table += "  model for MuJoCo: " + core::printable(row.mjcf.string()) + "/\n";
        done.push_back(*row.simulation);
    }
    return done.size() > 1 ? table + report::survey_text(done) : table;
}

}  // namespace fusee::batch
