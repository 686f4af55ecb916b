#include "fusee/gap_case/case.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "csv.h"
#include "fields.h"
#include "fusee/core/file.h"
#include "fusee/gap_case/columns.h"
#include "fusee/gap_case/reference.h"
#include "fusee/gap_case/toml.h"
#include "fusee/math/curve.h"

namespace fusee::gap_case {

namespace {

const char* const kSpringsAllowed = "the name of a CSV file with deflection_rad, se_torque_Nm, pe_torque_Nm";

/// Every reading needs a scatter: gaps are measured in sigmas.
void require_noise(const CaseToml& toml, const Sensors& sensors) {
    const auto require = [&toml](const char* path, double sum) {
        if (sum == 0.0) throw toml.fault(path, "0", "a scatter above 0: every sensor has one");
    };
    require("sensors.encoder_noise_rad", sensors.encoder_step + sensors.encoder_noise);
    require("sensors.torque_noise_Nm", sensors.torque_noise);
}

/// Optional tables: missing keys keep their defaults, and a remark names them.
void read_or_default(const CaseToml& toml, const std::string& table, const std::vector<NumberKey>& keys,
                     const std::vector<std::string>& others, std::vector<std::string>& remarks) {
    std::vector<std::string> left_out;
    for (const std::string& name : toml.read_numbers(table, keys, others))
        for (const NumberKey& key : keys)
            if (key.name == name) left_out.push_back(fmt::format("{} = {:g}", name, *key.to));
    if (!left_out.empty()) remarks.push_back(fmt::format("[{}] uses defaults for: {}", table, fmt::join(left_out, ", ")));
}

bool read_ramp(const CaseToml& toml) {
    const char* const path = "protocol.motor_ramp";
    const char* const allowed = R"("straight" or "smooth")";
    const std::string word = toml.text(path, allowed);
    if (word != "straight" && word != "smooth") throw toml.fault(path, '"' + word + '"', allowed);
    return word == "smooth";
}

std::map<Experiment, std::vector<std::string>> read_files(const CaseToml& toml) {
    std::vector<std::string> names;
    for (const Experiment experiment : kAllExperiments) names.emplace_back(to_string(experiment));
    (void)toml.read_numbers("experiments", {}, names);
    std::map<Experiment, std::vector<std::string>> files;
    for (const Experiment experiment : kAllExperiments) {
        const std::string path = std::string("experiments.") + to_string(experiment);
        if (toml.has(path)) files[experiment] = toml.files(path);
    }
    if (files.empty()) throw toml.fault("experiments", "missing", fmt::format("one file or more of {}", fmt::join(names, ", ")));
    return files;
}

void require_case(const CaseToml& toml) {
    if (toml.has("bench")) throw toml.fault("bench", "one element, not a joint", "a case with [rig], which describes a joint");
    std::vector<std::string> tables{"rig", "tolerance", "sensors", "protocol", "experiments"};
    for (std::string& table : column_tables()) tables.push_back(std::move(table));
    toml.allow_tables(tables);
}

/// @pre the springs are read: they give the rig's torque
void read_toml(const CaseToml& toml, Case& gap_case) {
    toml.require_numbers("rig", on_rig(rig_keys(gap_case.rig), gap_case.rig), {"springs"});
    gap_case.tolerance = usual_tolerance(gap_case.rig);
    gap_case.sensors = usual_sensors(gap_case.rig);
    read_or_default(toml, "tolerance", on_rig(tolerance_keys(gap_case.tolerance), gap_case.rig), {}, gap_case.remarks);
    read_or_default(toml, "sensors", on_rig(sensor_keys(gap_case.sensors), gap_case.rig), {}, gap_case.remarks);
    read_or_default(toml, "protocol", protocol_keys(gap_case.protocol), {"log_start", "motor_ramp"}, gap_case.remarks);
    if (toml.has("protocol.motor_ramp")) gap_case.protocol.smooth_motor_ramp = read_ramp(toml);
    require_noise(toml, gap_case.sensors);
    gap_case.files = read_files(toml);
    gap_case.columns = read_columns(toml);
}

/// All but the rows. @param hash gets the bytes read @return the name of the springs' file
std::string read_rig(const CaseFiles& files, Case& gap_case, core::Sha256& hash) {
    const CaseToml toml(files);
    gap_case.name = files.name();
    require_case(toml);
    if (!toml.has("rig.springs")) toml.require_numbers("rig", rig_keys(gap_case.rig), {"springs"});  // names the first that is missing
    hash.add(toml.bytes());
    std::string springs = toml.text("rig.springs", kSpringsAllowed);
    (void)toml.files("rig.springs");
    gap_case.rig.springs = read_springs(files, springs, [&hash](std::string_view bytes) { hash.add(bytes); });
    read_toml(toml, gap_case);
    return springs;
}

}  // namespace

void NominalRig::require_rising_springs() const {
    std::vector<double> x, se, pe;
    for (const SpringRow& row : springs) {
        x.push_back(row.deflection);
        se.push_back(row.se_torque);
        pe.push_back(row.pe_torque);
    }
    const math::CurvePtr se_curve = math::make_interpolant(x, se), pe_curve = math::make_interpolant(x, pe);
    double last_se = se_curve->value(0.0), last_pe = pe_curve->value(0.0);
    for (std::size_t i = 1; i <= kSpringSteps; ++i) {
        const double place = x.back() * static_cast<double>(i) / kSpringSteps;
        const double f_se = se_curve->value(place), f_pe = pe_curve->value(place);
        if (f_se <= last_se || f_pe <= last_pe)
            throw core::InvalidInput("springs", fmt::format("a torque that does not rise at {:.4g} rad", place), "both torques rising");
        last_se = f_se;
        last_pe = f_pe;
    }
}

const char* to_string(Side side) { return side == Side::kAgonist ? "agonist" : "antagonist"; }

const char* to_string(Experiment experiment) {
    static constexpr std::array<const char*, kExperiments> kNames{"breakaway",       "spring_pull",   "dead_band",
                                                                  "joint_stiffness", "cocontraction", "log"};
    return kNames.at(static_cast<std::size_t>(experiment));
}

std::size_t Rows::size(Experiment experiment) const {
    std::size_t size = 0;
    for_each_experiment(*this, [&](Experiment other, const auto& rows) { size += other == experiment ? rows.size() : 0; });
    return size;
}

std::size_t Rows::size() const {
    std::size_t size = 0;
    for_each_experiment(*this, [&](Experiment, const auto& rows) { size += rows.size(); });
    return size;
}

Case read_case(const CaseFiles& files) {
    Case gap_case;
    core::Sha256 hash;
    const std::string springs = read_rig(files, gap_case, hash);
    const auto seen = [&hash](std::string_view bytes) { hash.add(bytes); };
    gap_case.rows = read_tables(gap_case, files, {.seen = seen, .remarks = &gap_case.remarks});
    gap_case.sha256 = hash.hex();
    for (std::string& remark : check_rows(gap_case, files.folder(), springs)) gap_case.remarks.push_back(std::move(remark));
    return gap_case;
}

Case read_nominal(const fs::path& folder) {
    Case gap_case;
    core::Sha256 hash;
    (void)read_rig(CaseFiles(folder), gap_case, hash);
    gap_case.sha256 = hash.hex();
    return gap_case;
}

Case read_case(const fs::path& folder) { return read_case(CaseFiles(folder)); }

CaseKind kind_of_case(const fs::path& folder) {
    const CaseToml toml{CaseFiles(folder)};
    return toml.has("model") ? CaseKind::kSimulator : toml.has("bench") ? CaseKind::kElement : CaseKind::kJoint;
}

Rows read_inputs(const Case& nominal, const CaseFiles& files) {
    const Rows rows = read_tables(nominal, files, {.inputs_only = true});
    if (rows.size() == 0) {
        std::vector<std::string> names;
        for (const auto& [experiment, own] : nominal.files) names.insert(names.end(), own.begin(), own.end());
        throw core::InvalidInput(files.folder().string(), "none of the case's files",
                                 fmt::format("one or more of {}", fmt::join(names, ", ")));
    }
    return rows;
}

Rows read_inputs(const Case& nominal, const fs::path& folder) { return read_inputs(nominal, CaseFiles(folder)); }

}  // namespace fusee::gap_case
