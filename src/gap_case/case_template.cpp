#include "fusee/gap_case/case_template.h"

#include <fmt/format.h>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "keys.h"
#include "sheets.h"

namespace fs = std::filesystem;

namespace fusee::gap_case {

namespace {

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
