#include "fusee/effects/menu.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "fusee/core/lists.h"
#include "fusee/gap_case/reference.h"

namespace fusee::effects {

namespace {

/// Estimated cost [min]: to mount one side, spring or joint, and for one reading.
struct ExperimentCost {
    double mounting, reading;
};
constexpr std::array<ExperimentCost, gap_case::kExperiments> kCosts{
    {{10.0, 0.5}, {8.0, 0.2}, {5.0, 0.5}, {10.0, 0.02}, {3.0, 0.02}, {5.0, 0.002}}};
constexpr std::size_t kEveryPull = 5;  ///< every n-th pull of a template is enough to distinguish two causes
constexpr double kStronger = 1.5;      ///< push
constexpr double kSafePush = 0.9;      ///< of the greatest torque of K_SE: limit of a push
constexpr double kLowest = 0.2;        ///< of the highest level, if the case has no lower one
constexpr double kUsualLoad = 0.6;     ///< of the torque of the springs, if the case has no motor torque

/// The motor torques of a template for this rig.
core::Range torques(const gap_case::Case& gap_case) {
    core::Range range{std::numeric_limits<double>::infinity(), 0.0};
    const auto at_level = [&](double torque) { range = {std::min(range.low, torque), std::max(range.high, torque)}; };
    for (const gap_case::BreakAway& row : gap_case.rows.breakaway) at_level(row.motor_torque);
    for (const gap_case::DeadBandRow& row : gap_case.rows.dead_band) at_level(row.cocontraction);
    for (const gap_case::StiffnessRow& row : gap_case.rows.joint_stiffness) at_level(row.cocontraction);
    for (const gap_case::CocontractionRow& row : gap_case.rows.cocontraction) range.high = std::max(range.high, row.motor_torque);
    for (const gap_case::LogRow& row : gap_case.rows.log) range.high = std::max({range.high, row.torque_agonist, row.torque_antagonist});
    const gap_case::NominalRig::SpringRow& end = gap_case.rig.springs.back();
    if (range.high <= 0.0) range.high = kUsualLoad * (end.se_torque + end.pe_torque);
    range.low = std::clamp(range.low, 0.0, kLowest * range.high);
    return range;
}

template <typename Row, typename Same>
int drop_repeats(std::vector<Row>& rows, const Same& same) {
    const std::size_t before = rows.size();
    rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
    return static_cast<int>(before / rows.size());
}

void thin_pulls(std::vector<gap_case::SpringPull>& rows) {
    std::vector<gap_case::SpringPull> kept;
    std::size_t place = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool begins =
            i == 0 || rows[i].series != rows[i - 1].series || rows[i].side != rows[i - 1].side || rows[i].load != rows[i - 1].load;
        place = begins ? 0 : place + 1;
        if (place % kEveryPull == 0) kept.push_back(rows[i]);
    }
    rows = kept;
}

/// Only dead-bands, pushed harder within the range of K_SE; other levels are left out.
gap_case::Rows harder(const gap_case::Rows& usual, const gap_case::NominalRig& rig) {
    gap_case::Rows rows;
    const double digit = 1e4 / gap_case::reference_of(rig).decade();
    for (gap_case::DeadBandRow row : usual.dead_band) {
        const double push = std::min(kStronger * row.push_torque, kSafePush * rig.ratio() * rig.springs.back().se_torque);
        if (push < 0.5 * (1.0 + kStronger) * row.push_torque) continue;
        row.push_torque = std::round(push * digit) / digit;
        rows.dead_band.push_back(row);
    }
    return rows;
}

/// Only the log, its every `step`-th row, taking `slower` times as long.
gap_case::Rows log_at(const gap_case::Rows& usual, double slower, std::size_t step) {
    gap_case::Rows rows;
    for (std::size_t i = 0; i < usual.log.size(); i += step) {
        rows.log.push_back(usual.log[i]);
        rows.log.back().time *= slower;
    }
    return rows;
}

/// Different values in their order of size.
template <typename Row, typename Value>
std::vector<double> levels_of(const std::vector<Row>& rows, const std::vector<std::size_t>& chosen, const Value& value) {
    return core::sorted_unique(core::each<double>(chosen, [&](std::size_t i) { return value(rows[i]); }));
}

template <typename Row, typename Keep>
std::vector<std::size_t> rows_where(const std::vector<Row>& rows, const Keep& keep) {
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (keep(rows[i])) chosen.push_back(i);
    return chosen;
}

std::string span_of(const std::vector<double>& values) {
    if (values.size() == 1) return fmt::format("{:.4g}", values.front());
    return fmt::format("{:.4g} to {:.4g}", values.front(), values.back());
}
std::string list(const std::vector<double>& values) {
    std::vector<std::string> texts;
    for (const double value : values) texts.push_back(fmt::format("{:.4g}", value));
    return fmt::format("{}", fmt::join(texts, ", "));
}

using Sides = std::optional<gap_case::Side>;  ///< none: both
constexpr std::array<Sides, 3> kSides{gap_case::Side::kAgonist, gap_case::Side::kAntagonist, std::nullopt};
std::string name_of(Sides side) { return side ? std::string("the ") + to_string(*side) : "both sides"; }
int count_of(Sides side) { return side ? 1 : 2; }

class MenuWriter {
public:
    explicit MenuWriter(const gap_case::Case& gap_case) {
        gap_case::Rows usual = set_points(template_of(gap_case));
        thin_pulls(usual.spring_pull);
        break_away_repeats_ = drop_repeats(usual.breakaway, [](const gap_case::BreakAway& a, const gap_case::BreakAway& b) {
            return a.side == b.side && a.backdrive == b.backdrive && a.motor_torque == b.motor_torque;
        });
        dead_band_repeats_ = drop_repeats(usual.dead_band, [](const gap_case::DeadBandRow& a, const gap_case::DeadBandRow& b) {
            return a.cocontraction == b.cocontraction;
        });
        menu_.sheets = {usual, harder(usual, gap_case.rig), log_at(usual, 0.5, 2), log_at(usual, 2.0, 1)};
    }
    MeasurementMenu write() {
        break_aways();
        pulls();
        dead_bands(0, "");
        dead_bands(1, ", harder than usual");
        loops();
        cocontraction();
        log(0, "");
        log(2, ", at twice the usual speed");
        log(3, ", at half the usual speed");
        return std::move(menu_);
    }

private:
    void add(SheetMeasurement m, int mountings) {
        const ExperimentCost& cost = kCosts[static_cast<std::size_t>(m.experiment)];
        if (m.rows.empty()) return;
        m.cost = cost.mounting * mountings + cost.reading * static_cast<double>(m.rows.size()) * m.repeats;
        menu_.measurements.push_back(std::move(m));
    }
    void break_aways() {
        const std::vector<gap_case::BreakAway>& rows = menu_.sheets[0].breakaway;
        const core::Range ends{rows.front().motor_torque, rows[rows.size() / 4 - 1].motor_torque};
        for (const Sides side : kSides)
            for (const bool only_ends : {true, false}) {
                const auto chosen = rows_where(rows, [&](const gap_case::BreakAway& row) {
                    return (!side || row.side == to_string(*side)) &&
                           (!only_ends || row.motor_torque == ends.low || row.motor_torque == ends.high);
                });
                const auto levels = levels_of(rows, chosen, [](const gap_case::BreakAway& row) { return row.motor_torque; });
                add({gap_case::Experiment::kBreakAway, 0, chosen, break_away_repeats_,
                     fmt::format("Break {} away at {} Nm, driven and driven back, {} times each", name_of(side), list(levels),
                                 break_away_repeats_),
                     "motor_torque_Nm", levels},
                    count_of(side));
            }
    }
    void pulls() {
        const std::vector<gap_case::SpringPull>& rows = menu_.sheets[0].spring_pull;
        for (const bool series : {true, false})
            for (const Sides side : kSides) {
                const auto chosen =
                    rows_where(rows, [&](const gap_case::SpringPull& row) { return row.series == series && (!side || row.side == *side); });
                const auto levels = levels_of(rows, chosen, [](const gap_case::SpringPull& row) { return row.deflection; });
                add({gap_case::Experiment::kSpringPull, 0, chosen, 1,
                     fmt::format("Pull {} of {} alone to {} rad, load and unload", series ? "K_SE" : "K_PE", name_of(side), list(levels)),
                     "deflection_rad", levels},
                    count_of(side));
            }
    }
    /// All levels together, then the lowest, the middle and the highest alone.
    template <typename Row, typename Use>
    void at_levels(const std::vector<Row>& rows, const Use& use) {
        if (rows.empty()) return;
        const auto level = [](const Row& row) { return row.cocontraction; };
        const auto every = rows_where(rows, [](const Row&) { return true; });
        const std::vector<double> levels = levels_of(rows, every, level);
        use(every, levels);
        std::set<std::size_t> alone{0, levels.size() / 2, levels.size() - 1};
        if (levels.size() < 2) alone.clear();
        for (const std::size_t i : alone)
            use(rows_where(rows, [&](const Row& row) { return level(row) == levels[i]; }), std::vector{levels[i]});
    }
    void dead_bands(std::size_t sheet, const char* how) {
        const std::vector<gap_case::DeadBandRow>& rows = menu_.sheets[sheet].dead_band;
        at_levels(rows, [&](const std::vector<std::size_t>& chosen, const std::vector<double>& levels) {
            const auto pushes = levels_of(rows, chosen, [](const gap_case::DeadBandRow& row) { return row.push_torque; });
            add({gap_case::Experiment::kDeadBand, sheet, chosen, dead_band_repeats_,
                 fmt::format("Measure the dead-band at a co-contraction of {} Nm, pushed with {} Nm{}, {} times each", list(levels),
                             span_of(pushes), how, dead_band_repeats_),
                 "cocontraction_Nm", levels},
                1);
        });
    }
    void loops() {
        const std::vector<gap_case::StiffnessRow>& rows = menu_.sheets[0].joint_stiffness;
        at_levels(rows, [&](const std::vector<std::size_t>& chosen, const std::vector<double>& levels) {
            const double most = levels_of(rows, chosen, [](const gap_case::StiffnessRow& row) { return row.joint_torque; }).back();
            add({gap_case::Experiment::kJointStiffness, 0, chosen, 1,
                 fmt::format("Ramp the joint torque to {0:.4g} Nm, back, to -{0:.4g} Nm and back at a co-contraction of {1} Nm", most,
                             list(levels)),
                 "cocontraction_Nm", levels},
                1);
        });
    }
    void cocontraction() {
        const std::vector<gap_case::CocontractionRow>& rows = menu_.sheets[0].cocontraction;
        const auto chosen = rows_where(rows, [](const gap_case::CocontractionRow&) { return true; });
        const auto levels = levels_of(rows, chosen, [](const gap_case::CocontractionRow& row) { return row.motor_torque; });
        add({gap_case::Experiment::kCocontraction,
             0,
             chosen,
             1,
             fmt::format("Co-contract the free joint from {} Nm and back, {} readings each way", span_of(levels), levels.size()),
             "motor_torque_Nm",
             {levels.front(), levels.back()}},
            1);
    }
    void log(std::size_t sheet, const char* how) {
        const std::vector<gap_case::LogRow>& rows = menu_.sheets[sheet].log;
        const auto chosen = rows_where(rows, [](const gap_case::LogRow&) { return true; });
        const double seconds = std::round(rows.back().time * 10.0) / 10.0;
        add({gap_case::Experiment::kLog,
             sheet,
             chosen,
             1,
             fmt::format("Record a log of {:.4g} s with the set points of a case template{}", seconds, how),
             "t_s",
             {0.0, seconds}},
            1);
    }

    MeasurementMenu menu_;
    int break_away_repeats_ = 1, dead_band_repeats_ = 1;
};

}  // namespace

gap_case::CaseTemplate template_of(const gap_case::Case& gap_case) {
    gap_case::CaseTemplate t{gap_case.name, gap_case.rig, gap_case.tolerance, gap_case.sensors, gap_case.protocol, torques(gap_case)};
    if (!gap_case.rows.spring_pull.empty())
        t.rest_deflection = std::max(
            0.0, std::min_element(gap_case.rows.spring_pull.begin(), gap_case.rows.spring_pull.end(), [](const auto& a, const auto& b) {
                     return a.deflection < b.deflection;
                 })->deflection);
    return t;
}

MeasurementMenu measurement_menu(const gap_case::Case& gap_case) { return MenuWriter(gap_case).write(); }

}  // namespace fusee::effects
