#include "fusee/gap_case/case_template.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fields.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/lists.h"

namespace fusee::gap_case {

namespace {

constexpr const char* kHead = R"(# At the bench: {name}
{purpose}Fill in the empty cells of the CSV files; every line of a file is one reading, in the order in which it is taken. Then

    fusee diagnose THIS_FOLDER --out RESULT

A cell that is still empty is refused with its line. An experiment that was not done: take its line out of `[experiments]` in case.toml. A set
point that was not hit: write down what was commanded. `[sensors]` in case.toml decides what counts as noise: put in the rig's own figures.

## Units and signs
- Metres, newtons, radians, seconds, Nm. Degrees times 0.0174533 are radians.
- A capstan's angle theta and torque are positive when they wind the capstan's own cable in: co-contraction turns both up.
- A motor torque is the torque at the capstan before the gear's friction: (motor constant) x (current) x (gear ratio).
- The joint's angle q and torque are positive the same way: a positive joint torque moves q up. The agonist's pull moves q down.
- q = 0: both motors without torque, the joint hanging free of gravity.
{zero}
## What to do first
Let every axis run through its range ten times, so that grease and cables have settled. Keep the room's temperature. Do the experiments in the
order below: the first two tell the parts, the later ones the whole.
)";

constexpr const char* kBreakAway = R"(
## breakaway.csv: {rows} readings
Each motor subsystem alone, its capstan cut off from springs and joint, a cord on the capstan with a scale or weights.
1. Command `motor_torque_Nm` ({torques} Nm) and hold it.
2. `backdrive`: raise the load slowly until the capstan begins to turn against the motor. `load_torque_Nm` = load on the cord x capstan radius.
3. `drive`: begin with the capstan held by the load, then lower the load slowly until the motor lifts it. Write down that load.
4. Each {repeats} times, from another place of the gear each time. A load in `backdrive` lies above the motor torque, in `drive` below it.
)";

constexpr const char* kSpringPull = R"(
## spring_pull.csv: {rows} readings
Each spring with its cam and cable alone in a vice, a lever on its shaft; `se` the series spring, `pe` the parallel one, of both sides.
1. Turn to each `deflection_rad` ({first:.4g} to {last:.4g} rad, in capstan radians), upwards only (`load`), wait until the reading is still.
2. `torque_Nm` at the capstan: for `se` the cable's tension x capstan radius, for `pe` the torque on the cam's shaft.
3. The same downwards only (`unload`), without passing a set point: what differs is hysteresis.
)";

constexpr const char* kDeadBand = R"(
## dead_band.csv: {rows} readings
The whole joint. For each `cocontraction_Nm` ({torques} Nm), {repeats} times:
1. From rest command both motors to the co-contraction, in a straight line in {ramp:g} s, and wait {settle:g} s.
2. Push the joint up to `push_torque_Nm`, hold, in {push:g} s; release it to nothing in {release:g} s, damped by hand: it must not swing back.
3. Read `q_high_rad`. From where the joint rests then, push down the same way: `q_low_rad`, below the other.
{push_text})";

constexpr const char* kStiffness = R"(
## joint_stiffness.csv: {rows} readings
Both motors held at `cocontraction_Nm` ({torques} Nm). The joint's torque goes from 0 up (`load+`), back to 0 (`unload+`), down (`load-`) and
back (`unload-`), {phase:g} s each, without a jump and without turning round in between. Read `q_rad` at each `joint_torque_Nm`.
)";

constexpr const char* kCocontraction = R"(
## cocontraction.csv: {rows} readings
The joint free. Both motor torques together from rest up to {most:g} Nm in {phase:g} s (`up`) and down again (`down`). At each
`motor_torque_Nm` read both capstans and the joint.
)";

constexpr const char* kLog = R"(
## log.csv: {rows} rows
A time log at {rate:g} Hz. Co-contract to the first row's torques in {ramp:g} s, wait {settle:g} s, then play the three input columns and record the
angles. Where the joint cannot be pushed by a motor, leave `joint_torque_Nm` at 0 and end the file before the first row that asks for it.
)";

std::string different(const std::vector<double>& figures) { return fmt::format("{}", fmt::join(core::sorted_unique(figures), ", ")); }

template <class Row>
std::string torques_of(const std::vector<Row>& rows, double Row::*torque) {
    std::vector<double> all;
    for (const Row& row : rows) all.push_back(row.*torque);
    return different(all);
}

/// Meaning of a push set point.
std::string push_text(const CaseTemplate& t, const std::vector<DeadBandRow>& rows) {
    if (!t.push) return "";
    double within = std::numeric_limits<double>::infinity();
    for (const DeadBandRow& row : rows) {
        if (row.repeat > 1) continue;
        const double reach = t.push(row.cocontraction).within_laws;
        if (reach < row.push_torque) within = std::min(within, reach);
    }
    std::string text =
        "\nThe pushes are those of `fusee simulate`: 1.05 times the least one after which a stronger one reads the same, unless the\n"
        "profile gives `simulate.push_torque_Nm`. A weaker push reads a narrower dead-band.\n";
    if (std::isfinite(within))
        text += fmt::format(
            "On the way a spring goes beyond the end of its law, which a push of at most {:.3g} Nm does not: look at the cable and at\n"
            "the cam's end before the first push.\n",
            within);
    return text;
}

std::string zero_text(double rest) {
    if (rest == 0.0) return "- theta = 0: the springs relaxed, no torque on them.\n";
    return fmt::format(
        "- The springs rest on their preload stops. Angles and deflections count from where they would carry nothing: with the springs on\n"
        "  their stops and the motors without torque both theta are {0:.6g} rad, and so is each spring's deflection. Add {0:.6g} to what "
        "an\n"
        "  encoder shows that was set to 0 there.\n",
        rest);
}

std::ptrdiff_t repeats_of_first(const std::vector<BreakAway>& rows) {
    return std::count_if(rows.begin(), rows.end(), [&first = rows.front()](const BreakAway& row) {
        return row.side == first.side && row.backdrive == first.backdrive && row.motor_torque == first.motor_torque;
    });
}

/// The text of BENCH.md: how to do each experiment of the template, with its set points. Markdown.
std::string experiment_sheets(const CaseTemplate& t, const Rows& rows) {
    using fmt::arg;
    const Protocol& p = t.protocol;
    std::string text = fmt::format(kHead, arg("name", t.name), arg("purpose", t.purpose), arg("zero", zero_text(t.rest_deflection)));
    if (!rows.breakaway.empty())
        text += fmt::format(kBreakAway, arg("rows", rows.breakaway.size()),
                            arg("torques", torques_of(rows.breakaway, &BreakAway::motor_torque)),
                            arg("repeats", repeats_of_first(rows.breakaway)));
    if (!rows.spring_pull.empty()) {
        const auto [least, most] =
            std::minmax_element(rows.spring_pull.begin(), rows.spring_pull.end(),
                                [](const SpringPull& a, const SpringPull& b) { return a.deflection < b.deflection; });
        text +=
            fmt::format(kSpringPull, arg("rows", rows.spring_pull.size()), arg("first", least->deflection), arg("last", most->deflection));
    }
    if (!rows.dead_band.empty())
        text += fmt::format(
            kDeadBand, arg("rows", rows.dead_band.size()), arg("torques", torques_of(rows.dead_band, &DeadBandRow::cocontraction)),
            arg("repeats", rows.dead_band.back().repeat), arg("ramp", p.motor_ramp), arg("settle", p.motor_settle),
            arg("push", p.dead_band_push), arg("release", p.dead_band_release), arg("push_text", push_text(t, rows.dead_band)));
    if (!rows.joint_stiffness.empty())
        text += fmt::format(kStiffness, arg("rows", rows.joint_stiffness.size()),
                            arg("torques", torques_of(rows.joint_stiffness, &StiffnessRow::cocontraction)),
                            arg("phase", p.joint_stiffness_phase));
    if (!rows.cocontraction.empty())
        text += fmt::format(kCocontraction, arg("rows", rows.cocontraction.size()), arg("most", t.torques.high),
                            arg("phase", p.cocontraction_phase));
    if (!rows.log.empty())
        text += fmt::format(kLog, arg("rows", rows.log.size()), arg("rate", t.sensors.log_rate), arg("ramp", p.motor_ramp),
                            arg("settle", p.motor_settle));
    return text;
}

const char* const kSprings = "nominal_springs.csv";

std::string csv_of(Experiment experiment) { return std::string(to_string(experiment)) + ".csv"; }

std::string table_text(const std::string& name, const char* comment, const std::vector<NumberKey>& keys) {
    std::string text = fmt::format("\n[{}] # {}\n", name, comment);
    for (const NumberKey& key : keys) {
        if (!(*key.to >= key.low && *key.to <= key.high))
            throw core::InvalidInput(name + "." + key.name, fmt::format("{:g}", *key.to),
                                     fmt::format("{:g} to {:g} {}", key.low, key.high, key.unit));
        text += fmt::format("{:<44} # {}\n", fmt::format("{} = {}", key.name, *key.to), key.meaning);
    }
    return text;
}

/// @param t by value: the keys point into it
std::string case_toml(CaseTemplate t, const Rows& rows) {
    std::string text = fmt::format(
        "# A gap case of {}: nominal rig, and the files with the measurements (BENCH.md).\n"
        "# SI: metres, newtons, radians, seconds, Nm; the unit stands at the end of each name.\n",
        t.name);
    text += table_text("rig", "the nominal rig", on_rig(rig_keys(t.rig), t.rig));
    text +=
        fmt::format("{:<44} # {}\n", fmt::format("springs = \"{}\"", kSprings), "torques at the capstan over deflection, both sides equal");
    text += table_text("tolerance", "one sigma of build tolerances: a gap within them is not an effect",
                       on_rig(tolerance_keys(t.tolerance), t.rig));
    text += table_text("sensors", "put in those of the rig", on_rig(sensor_keys(t.sensors), t.rig));
    text += table_text("protocol", "how long each phase takes [s]", protocol_keys(t.protocol));
    text += fmt::format("{:<44} # {}\n", fmt::format("motor_ramp = \"{}\"", t.protocol.smooth_motor_ramp ? "smooth" : "straight"),
                        "or smooth: 3 s^2 - 2 s^3");
    text += "\n[experiments] # remove what was not measured\n";
    for (const Experiment experiment : kAllExperiments)
        if (rows.size(experiment) > 0) text += fmt::format("{0} = \"{0}.csv\"\n", to_string(experiment));
    return text;
}

std::string springs_csv(const NominalRig& rig) {
    std::string text = "deflection_rad,se_torque_Nm,pe_torque_Nm\n";
    for (const NominalRig::SpringRow& row : rig.springs) text += fmt::format("{},{},{}\n", row.deflection, row.se_torque, row.pe_torque);
    return text;
}

}  // namespace

std::vector<std::string> case_template_files() {
    std::vector<std::string> names{"case.toml", kSprings, "BENCH.md"};
    for (const Experiment experiment : kAllExperiments) names.push_back(csv_of(experiment));
    return names;
}

CaseTexts case_template_texts(const CaseTemplate& empty) { return case_template_texts(empty, set_points(empty)); }

CaseTexts case_template_texts(const CaseTemplate& empty, const Rows& set_points) {
    Case files;
    for (const Experiment experiment : kAllExperiments)
        if (set_points.size(experiment) > 0) files.files[experiment] = {csv_of(experiment)};
    CaseTexts texts = row_texts(files, set_points);
    texts["case.toml"] = case_toml(empty, set_points);
    texts[kSprings] = springs_csv(empty.rig);
    texts["BENCH.md"] = experiment_sheets(empty, set_points);
    return texts;
}

void write_case_template(const CaseTemplate& empty, const fs::path& folder) { write_case_template(empty, set_points(empty), folder); }

void write_case_template(const CaseTemplate& empty, const Rows& set_points, const fs::path& folder) {
    const CaseTexts texts = case_template_texts(empty, set_points);
    core::make_folder(folder);
    for (const auto& [name, text] : texts) core::write_file(folder / name, text);
}

}  // namespace fusee::gap_case
