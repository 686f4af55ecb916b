#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "fusee/batch/batch.h"
#include "fusee/core/text.h"

namespace fusee::batch {

const char* to_string(Outcome outcome) {
    switch (outcome) {
        case Outcome::kMade:
            return "made";
        case Outcome::kRefused:
            return "refused";
        case Outcome::kBadInput:
            return "bad input";
        case Outcome::kFailed:
            return "failed";
        case Outcome::kInterrupted:
            return "not begun";
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
    const auto count = [&](core::Severity severity) {
        return std::count_if(row.result.findings.begin(), row.result.findings.end(),
                             [&](const core::Finding& f) { return f.severity == severity; });
    };
    const double width = row.result.dead_band_peak_deg;
    const double change = row.result.worst_dead_band_change;
    const std::string exported = std::isfinite(change) ? fmt::format(", of the files' joints within {:.3f} % of it", 100.0 * change) : "";
    const std::string dead_band = std::isfinite(width) ? fmt::format("exact dead-band {:.1f} deg at peak torque", width) + exported
                                                       : "the springs do not cover the dead-band at peak torque";
    return fmt::format("{}/  worst arm error {:.4f} %, {}, {} rules passed, {} to review", row.result.folder.string(),
                       100.0 * row.result.worst_arm_error, dead_band, count(core::Severity::kPass), count(core::Severity::kReview));
}

/// What went wrong, or what binds; under a row.
std::string details(const Ended& row, const core::Findings& findings) {
    std::string lines;
    std::istringstream error(row.error);
    for (std::string line; std::getline(error, line);) lines += "    " + line + "\n";
    if (!lines.empty()) return lines;
    for (const core::Finding& f : findings)
        if (f.severity != core::Severity::kPass) lines += "    " + core::to_line(f) + "\n";
    return lines;
}

/// "profiles/pnrvsa.toml  made         1.20 s  "; `done` is the word for what went well.
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
        table += details(row, row.result.findings);
    }
    return table;
}

std::string closing_table(const std::vector<SimulationRow>& rows) {
    std::string table;
    std::vector<report::Simulation> done;
    for (const SimulationRow& row : rows) {
        table += beginning(row, rows, "simulated") + (row.simulation ? row.folder.string() + "/" : "") + "\n" + details(row, row.refusal);
        if (!row.simulation) continue;
        table += report::simulation_text(*row.simulation);
        done.push_back(*row.simulation);
    }
    return done.size() > 1 ? table + report::survey_text(done) : table;
}

}  // namespace fusee::batch
