#include <fmt/format.h>

#include "arrays.h"
#include "fusee/pipeline/headline.h"
#include "fusee/pipeline/simulate.h"
#include "fusee/profile/places.h"
#include "work.h"

namespace fusee::python {

namespace {

using pipeline::SimulatedLevel, pipeline::EquilibriumRow, pipeline::PathPoint;

/// A simulation, or the law's refusal.
struct SimulationResult {
    std::shared_ptr<const pipeline::Simulation> value;  ///< null: refused
    core::Findings findings;                            ///< of the law and of equilibria that were asked for
    [[nodiscard]] const std::vector<SimulatedLevel>& levels() const {
        static const std::vector<SimulatedLevel> kNone;
        return value ? value->levels : kNone;
    }
};

/// An array over the levels of co-contraction.
template <class Get>
auto level_array(const Get& get) {
    return [get](const SimulationResult& s) { return column(s.value, s.levels(), get); };
}

py::array_t<double> sensitivities(const SimulationResult& s) {
    const auto& levels = s.levels();
    constexpr py::ssize_t kNumber = sizeof(double);
    return view<double>(s.value, levels.empty() ? nullptr : levels.front().sensitivity.data(),
                        {static_cast<py::ssize_t>(levels.size()), 3, 3},
                        {sizeof(SimulatedLevel), kNumber, 3 * kNumber});  // Eigen's matrices stand column by column
}

py::array_t<double> noises(const SimulationResult& s) {
    const auto& levels = s.levels();
    return view<double>(s.value, levels.empty() ? nullptr : levels.front().noise.data(), {static_cast<py::ssize_t>(levels.size()), 3},
                        {sizeof(SimulatedLevel), sizeof(double)});
}

/// The path of a push-and-release test: joint torque and angle, as columns.
py::dict path_of(const Owner& owner, const std::vector<PathPoint>& points) {
    py::dict columns;
    columns["joint_torque"] = column(owner, points, [](const PathPoint& p) -> const double& { return p.joint_torque; });
    columns["q"] = column(owner, points, [](const PathPoint& p) -> const double& { return p.q; });
    columns["load_1"] = column(owner, points, [](const PathPoint& p) -> const double& { return p.load_1; });
    columns["load_2"] = column(owner, points, [](const PathPoint& p) -> const double& { return p.load_2; });
    return columns;
}

SimulationResult simulate(const py::object& given, int levels, std::optional<double> push_torque,
                          const std::vector<std::array<double, 3>>& at) {
    const LoadedProfile loaded = profile_of(given);
    pipeline::SimulateOptions options{levels, push_torque, {}};
    for (const auto& [tau_1, tau_2, tau_q] : at) options.at.emplace_back(tau_1, tau_2, tau_q);
    return run(py::none(), [&](Watch&) -> SimulationResult {
        auto made = profile::with_places(loaded.value, [&] { return pipeline::simulate(loaded.value, options); });
        if (!made) return {nullptr, made.refusal()};
        const auto value = std::make_shared<const pipeline::Simulation>(std::move(made).value());
        core::Findings findings = value->findings;
        core::append(findings, pipeline::refusals(*value));
        return {value, std::move(findings)};
    });
}

void bind_equilibrium(py::module_& module) {
    py::class_<EquilibriumRow>(module, "Equilibrium",
                               "The joint at rest under three torques (tau_1, tau_2, tau_q): of both motors at the capstan, and of the "
                               "joint. NaN if it does not rest.")
        .def_property_readonly(
            "torque", [](const EquilibriumRow& e) { return py::array_t<double>(3, e.torque.data()); },
            "The three torques that were asked for [Nm].")
        .def_property_readonly(
            "z", [](const EquilibriumRow& e) { return py::array_t<double>(3, e.z.data()); }, doc("pipeline::EquilibriumRow::z"))
        .def_property_readonly(
            "sensitivity",
            [](const EquilibriumRow& e) {
                return py::array_t<double>(std::vector<py::ssize_t>{3, 3}, std::vector<py::ssize_t>{8, 24}, e.sensitivity.data());
            },
            doc("pipeline::EquilibriumRow::sensitivity"))
        .def_readonly("joint_stiffness", &EquilibriumRow::joint_stiffness, "Both capstans held [Nm/rad].")
        .def_property_readonly(
            "dead_band", [](const EquilibriumRow& e) { return e.dead_band ? std::optional(e.dead_band->exact_width) : std::nullopt; },
            "Exact width [rad]; None under a joint torque.")
        .def_readonly("findings", &EquilibriumRow::refusal, doc("pipeline::EquilibriumRow::refusal"));
}

void def_levels(py::class_<SimulationResult>& type) {
    using Level = SimulatedLevel;
    type.def_property_readonly("tau", level_array([](const Level& l) -> const double& { return l.dead_band.tau; }),
                               doc("actuator::DeadBand::tau"))
        .def_property_readonly("linear", level_array([](const Level& l) -> const double& { return l.dead_band.linear; }),
                               doc("actuator::DeadBand::linear"))
        .def_property_readonly("exact_width", level_array([](const Level& l) -> const double& { return l.dead_band.exact_width; }),
                               "Exact dead-band, full width at the joint: between the outermost resting places that stiction allows [rad].")
        .def_property_readonly("measured_width", level_array([](const Level& l) -> const double& { return l.dead_band.measured_width; }),
                               doc("pipeline::SimulatedDeadBand::measured_width"))
        .def_property_readonly("covered", level_array([](const Level& l) -> const bool& { return l.dead_band.covered; }),
                               doc("actuator::DeadBand::covered"))
        .def_property_readonly("joint_stiffness", level_array([](const Level& l) -> const double& { return l.dead_band.joint_stiffness; }),
                               doc("actuator::DeadBand::joint_stiffness"))
        .def_property_readonly("free_joint_stiffness",
                               level_array([](const Level& l) -> const double& { return l.dead_band.free_joint_stiffness; }),
                               doc("actuator::DeadBand::free_joint_stiffness"))
        .def_property_readonly("theta", level_array([](const Level& l) -> const double& { return l.dead_band.theta; }),
                               doc("actuator::DeadBand::theta"))
        .def_property_readonly("condition_6", level_array([](const Level& l) -> const double& { return l.dead_band.condition_6; }),
                               doc("actuator::DeadBand::condition_6"))
        .def_property_readonly("built_low", level_array([](const Level& l) -> const double& { return l.built.low; }),
                               doc("pipeline::SimulatedLevel::built"))
        .def_property_readonly("built_high", level_array([](const Level& l) -> const double& { return l.built.high; }),
                               doc("pipeline::SimulatedLevel::built"))
        .def_property_readonly("sensitivity", &sensitivities, doc("pipeline::SimulatedLevel::sensitivity"))
        .def_property_readonly("noise", &noises, doc("pipeline::SimulatedLevel::noise"));
}

py::dict release_path(const SimulationResult& s) {
    py::dict both;
    if (!s.value || !s.value->path) return both;
    both["up"] = path_of(s.value, s.value->path->up);
    both["down"] = path_of(s.value, s.value->path->down);
    return both;
}

}  // namespace

void bind_simulation(py::module_& module) {
    bind_equilibrium(module);
    py::class_<SimulationResult> type(
        module, "Simulation",
        "The simulated joint: arrays over the levels of co-contraction, and the equilibria that were asked for. Of the paper's "
        "relatives only the linear figures are known.");
    type.def_property_readonly(
            "ok", [](const SimulationResult& s) { return s.value != nullptr && no_error(s); },
            "Is there a simulation, with every equilibrium that was asked for?")
        .def_readonly("findings", &SimulationResult::findings, "Of the law, and why an equilibrium that was asked for does not exist.")
        .def_property_readonly(
            "condition_6_verdict",
            [](const SimulationResult& s) {
                return s.value ? pipeline::to_string(pipeline::condition_verdict(s.value->condition)) : "not known";
            },
            doc("pipeline::ConditionVerdict"))
        .def_property_readonly(
            "gaps", [](const SimulationResult& s) { return s.value ? s.value->gaps : std::vector<std::string>{}; },
            doc("pipeline::Simulation::gaps"))
        .def_property_readonly(
            "equilibria", [](const SimulationResult& s) { return s.value ? s.value->equilibria : std::vector<EquilibriumRow>{}; },
            "Of the torques that were asked for.")
        .def_property_readonly("release_path", &release_path,
                               "Push and release at peak torque, \"up\" and \"down\": joint_torque [Nm], q [rad], load_1 and load_2 [Nm]; "
                               "empty where it is not known.")
        .def("__repr__", [](const SimulationResult& s) {
            return s.value ? fmt::format("<Simulation of {}, {} levels>", s.value->provenance.name, s.value->levels.size())
                           : fmt::format("<Simulation refused: {} findings>", s.findings.size());
        });
    def_levels(type);
    module.def("simulate", &simulate, py::arg("profile"), py::kw_only(), py::arg("levels") = 0, py::arg("push_torque") = py::none(),
               py::arg("at") = std::vector<std::array<double, 3>>{},
               "The joint at rest and pushed, at `levels` co-contractions (0: as the profile says), with its stiffness and noise; of the "
               "paper's relatives the comparison only. `push_torque` is that of the push-and-release test at the joint [Nm]; None: as the "
               "profile says, 0: as strong as needed. `at` lists torques (tau_1, tau_2, tau_q) [Nm] whose equilibria are wanted; one that "
               "does not exist is a finding. Needs no parts. Raises InvalidInput and IoError for a profile that cannot be read.");
}

}  // namespace fusee::python
