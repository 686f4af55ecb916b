#include "fusee/plant/case_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace fusee::plant {

namespace {

/// Streams of a case: rig, its tolerances, noise of the fit's and of the held-out experiments.
enum Purpose : std::uint64_t { kRig = 1, kBuild, kNoise, kHeldoutNoise };
constexpr double kHeldoutSession = 900.0;  // [s] after switching on: behind the last of the fit's experiments
constexpr std::array<const char*, 2> kSideNames{"agonist", "antagonist"};
constexpr std::size_t kSpringRows = 200;

std::string tables_of_sensors(const TestRig& b) {
    const Tolerance& t = b.tolerance;
    const Sensors& s = b.sensors;
    std::string text = fmt::format(
        "\n[tolerance] # relative unless a unit is named\ngear_load_friction = {}\nradii = {}\ninertia = {}\nspring_rate = {}\n"
        "se_radius_m = {}\npe_radius_m = {}\nse_preload_rad = {}\npe_preload_m = {}\ntorque_scale = {}\njoint_coulomb_Nm = {}\n"
        "joint_offset_rad = {}\n",
        t.mu, t.radii, t.inertia, t.spring_rate, t.se_radius, t.pe_radius, t.se_preload, t.pe_preload, t.torque_scale, t.joint_coulomb,
        t.joint_offset);
    text += fmt::format(
        "\n[sensors]\nencoder_step_rad = {}\nencoder_noise_rad = {}\ntorque_noise_relative = {}\ntorque_noise_Nm = {}\n"
        "breakaway_scatter = {}\nlog_rate_Hz = {}\n",
        s.encoder_step, s.encoder_noise, s.torque_noise_relative, s.torque_noise, s.breakaway_scatter, s.log_rate);
    return text;
}

std::string table_of_protocol(const Protocol& p) {
    return fmt::format(
        "\n[protocol]\nmotor_ramp_s = {}\nmotor_settle_s = {}\ndead_band_push_s = {}\ndead_band_release_s = {}\n"
        "joint_stiffness_phase_s = {}\ncocontraction_phase_s = {}\n"
        "motor_ramp = \"straight\"\n"
        "log_start = \"co-contracted from rest to the first row's torques in {} s, settled {} s\"\n",
        p.motor_ramp, p.motor_settle, p.dead_band_push, p.dead_band_release, p.joint_stiffness_phase, p.cocontraction_phase, p.motor_ramp,
        p.motor_settle);
}

bool is_listed(const std::string& experiment, const std::vector<std::string>& experiments) {
    return experiments.empty() || std::find(experiments.begin(), experiments.end(), experiment) != experiments.end();
}

template <class Row, class Line>
std::string csv(const char* header, const std::vector<Row>& rows, const Line& line) {
    std::string text = header;
    text += '\n';
    for (const Row& row : rows) line(std::back_inserter(text), row);
    return text;
}

}  // namespace

std::string case_toml(const TestRig& test_rig, const std::vector<std::string>& experiments) {
    const Nominal& n = test_rig.nominal;
    std::string text = fmt::format(
        "# nominal rig: what the model is told; 1-sigma build tolerances; sensors\n[rig]\ncapstan_radius_m = {:.6g}\n"
        "joint_radius_m = {:.6g}\ngear_load_friction = {:.6g}\nmotor_inertia_kgm2 = {:.6g}\njoint_inertia_kgm2 = {:.6g}\n"
        "motor_viscous_Nms = {:.6g}\njoint_viscous_Nms = {:.6g}\nse_torsion_rate_Nm_per_rad = {:.8g}\n"
        "pe_compression_rate_N_per_m = {:.8g}\nsprings = \"nominal_springs.csv\"\n",
        n.capstan_radius, n.joint_radius, n.mu, n.motor_inertia, n.joint_inertia, n.motor_viscous, n.joint_viscous, n.torsion_rate,
        n.compression_rate);
    text += tables_of_sensors(test_rig) + table_of_protocol(test_rig.protocol) + "\n[experiments]\n";
    for (const char* name : {"breakaway", "spring_pull", "dead_band", "joint_stiffness", "cocontraction", "log"})
        if (is_listed(name, experiments)) text += fmt::format("{0} = \"{0}.csv\"\n", name);
    return text;
}

/// Rows at even steps of deflection and load together, dense in flat and steep parts.
std::string springs_csv(const Nominal& nominal) {
    const SpringCurves& s = nominal.springs;
    std::vector<double> way = load_of(s);
    const double top = way.back();
    for (std::size_t i = 0; i < way.size(); ++i) way[i] = way[i] / top + s.deflection[i] / s.deflection.back();
    std::string text = "deflection_rad,se_torque_Nm,pe_torque_Nm\n";
    for (std::size_t i = 0; i <= kSpringRows; ++i) {
        const double x = i == kSpringRows ? s.deflection.back() : torque_at(way, s.deflection, 2.0 * static_cast<double>(i) / kSpringRows);
        fmt::format_to(std::back_inserter(text), "{:.8g},{:.8g},{:.8g}\n", x, torque_at(s.deflection, s.se, x),
                       torque_at(s.deflection, s.pe, x));
    }
    return text;
}

CaseFiles experiment_files(const Measured& m) {
    CaseFiles files;
    files["breakaway.csv"] = csv("side,direction,motor_torque_Nm,load_torque_Nm", m.breakaway, [](auto out, const BreakAwayRow& r) {
        fmt::format_to(out, "{},{},{:.6g},{:.6g}\n", kSideNames[r.side], r.backdrive ? "backdrive" : "drive", r.motor, r.load);
    });
    files["spring_pull.csv"] = csv("spring,side,phase,deflection_rad,torque_Nm", m.spring_pull, [](auto out, const PullRow& r) {
        fmt::format_to(out, "{},{},{},{:.6g},{:.6g}\n", r.series ? "se" : "pe", kSideNames[r.side], r.load ? "load" : "unload",
                       r.deflection, r.torque);
    });
    files["dead_band.csv"] =
        csv("cocontraction_Nm,repeat,push_torque_Nm,q_low_rad,q_high_rad", m.dead_band, [](auto out, const DeadBandRow& r) {
            fmt::format_to(out, "{:.6g},{},{:.6g},{:.6g},{:.6g}\n", r.cocontraction, r.repeat, r.push, r.q_low, r.q_high);
        });
    files["joint_stiffness.csv"] = csv(
        "cocontraction_Nm,phase,joint_torque_Nm,q_rad", m.joint_stiffness,
        [](auto out, const StiffnessRow& r) { fmt::format_to(out, "{:.6g},{},{:.6g},{:.6g}\n", r.cocontraction, r.phase, r.torque, r.q); });
    files["cocontraction.csv"] =
        csv("phase,motor_torque_Nm,theta_agonist_rad,theta_antagonist_rad,q_rad", m.cocontraction, [](auto out, const CocontractionRow& r) {
            fmt::format_to(out, "{},{:.6g},{:.6g},{:.6g},{:.6g}\n", r.up ? "up" : "down", r.motor, r.theta[0], r.theta[1], r.q);
        });
    files["log.csv"] =
        csv("t_s,motor_torque_agonist_Nm,motor_torque_antagonist_Nm,joint_torque_Nm,theta_agonist_rad,theta_antagonist_rad,q_rad", m.log,
            [](auto out, const LogRow& r) {
                fmt::format_to(out, "{:.4f},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", r.time, r.command.motor[0], r.command.motor[1],
                               r.command.joint, r.theta[0], r.theta[1], r.q);
            });
    return files;
}

TestRig draw_test_rig(std::uint64_t seed, std::uint64_t index, bool linear_springs) {
    Random rig(seed, index, kRig), made(seed, index, kBuild);
    TestRig test_rig;
    test_rig.nominal = draw_nominal(rig, linear_springs);
    test_rig.truth = build(test_rig.nominal, test_rig.tolerance, made);
    return test_rig;
}

CaseFiles make_case(std::uint64_t seed, std::uint64_t index, const std::vector<Effect>& effects, const Engine& engine,
                    const Conditions& conditions) {
    TestRig test_rig = draw_test_rig(seed, index, conditions.linear_springs);
    const std::string stated = case_toml(test_rig, conditions.experiments);
    Sensors& s = test_rig.sensors;
    for (double* noise : {&s.encoder_noise, &s.torque_noise, &s.torque_noise_relative}) *noise *= conditions.noise;
    for (const Effect& effect : effects) apply(effect, test_rig.truth);
    const double scale = range_of(test_rig.nominal).scale;
    Random noise(seed, index, kNoise), heldout_noise(seed, index, kHeldoutNoise);
    CaseFiles files = experiment_files(measure(test_rig, set_points(false, scale), noise, 0.0, engine));
    std::erase_if(files, [&](const auto& file) { return !is_listed(file.first.substr(0, file.first.find('.')), conditions.experiments); });
    for (auto& [name, bytes] : experiment_files(measure(test_rig, set_points(true, scale), heldout_noise, kHeldoutSession, engine)))
        files["heldout/" + name] = bytes;
    files["case.toml"] = stated;
    files["nominal_springs.csv"] = springs_csv(test_rig.nominal);
    return files;
}

}  // namespace fusee::plant
