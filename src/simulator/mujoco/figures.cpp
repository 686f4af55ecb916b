#include "figures.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "fusee/core/error.h"

namespace fusee::mujoco {

namespace {

// One sigma of what a file states: a part by its CAD, a drive by its data sheet, a loss by an estimate.
constexpr double kMass = 0.02, kInertia = 0.05, kStiffness = 0.05, kGain = 0.03, kServo = 0.05, kLoss = 0.1;
constexpr double kSpringRef = 0.02;  // of the angle at which a spring is at rest [rad]; a tenth in metres
// Usual sizes where the file has 0, as shares of the torque that moves the joint, at speeds and angles that are usual.
constexpr double kUsualShare = 0.05, kUsualSpeed = 2.0, kUsualAngle = 0.5, kUsualInertia = 0.2;
constexpr double kMostUsual = 100.0;         // range of such an effect, in usual sizes
constexpr double kUsualAcceleration = 10.0;  // of a joint without a bounded drive [rad/s^2]
constexpr double kUsualLag = 0.1;            // of a position servo in motion [rad]

struct Units {
    const char *position, *force, *loss, *inertia, *stiffness;
};
constexpr Units kTurning{"rad", "Nm", "Nms", "kgm2", "Nm_per_rad"}, kSliding{"m", "N", "Ns_per_m", "kg", "N_per_m"};

const Units& units_of(const mjModel& model, int joint) { return model.jnt_type[joint] == mjJNT_SLIDE ? kSliding : kTurning; }

int freedoms_of(const mjModel& model, int joint) { return model.jnt_type[joint] == mjJNT_BALL ? 3 : 1; }

bool drives(const mjModel& model, int actuator, int joint) {
    const int kind = model.actuator_trntype[actuator];
    return (kind == mjTRN_JOINT || kind == mjTRN_JOINTINPARENT) && model.actuator_trnid[2 * actuator] == joint;
}

/// The force or torque that usually moves a joint.
double usual_force(const mjModel& model, int joint) {
    double most = 0.0;
    for (int a = 0; a < model.nu; ++a) {
        if (!drives(model, a, joint)) continue;
        const double gear = std::abs(model.actuator_gear[6 * a]), gain = std::abs(model.actuator_gainprm[mjNGAIN * a]);
        const bool servo = model.actuator_biasprm[mjNBIAS * a + 1] != 0.0;
        double force = model.actuator_ctrllimited[a] != 0 ? gain * std::abs(model.actuator_ctrlrange[2 * a + 1]) : 0.0;
        if (servo) force = gain * kUsualLag;
        if (model.actuator_forcelimited[a] != 0) {
            const double limit = std::abs(model.actuator_forcerange[2 * a + 1]);
            force = force > 0.0 ? std::min(force, limit) : limit;
        }
        most = std::max(most, gear * force);
    }
    return most > 0.0 ? most : kUsualAcceleration * model.dof_M0[model.jnt_dofadr[joint]];
}

class Writer {
public:
    explicit Writer(const mjModel& model) : model_(model) {}

    Description all() {
        for (int body = 1; body < model_.nbody; ++body)
            if (model_.body_weldid[body] != 0 && model_.body_mass[body] > 0.0) add_body(body);
        for (int joint = 0; joint < model_.njnt; ++joint)
            if (model_.jnt_type[joint] != mjJNT_FREE) add_joint(joint);
        for (int actuator = 0; actuator < model_.nu; ++actuator) add_actuator(actuator);
        std::set<std::string> names;
        for (const Figure& figure : own_.figures)
            if (!names.insert(figure.name).second)
                throw core::InvalidInput(figure.name, "two figures of this name",
                                         "names of bodies, joints and actuators that differ in letters, figures, _ and -");
        return std::move(own_);
    }

private:
    void add(Figure figure) { own_.figures.push_back(std::move(figure)); }

    void add_body(int body) {
        const std::string name = name_of(model_, mjOBJ_BODY, body);
        const double mass = model_.body_mass[body];
        const std::vector<double> inertia(model_.body_inertia + 3 * body, model_.body_inertia + 3 * body + 3);
        add({name + "_mass_kg", mass, kMass, 0.0, 1e-9 * mass, [body, mass, inertia](mjModel& to, double value) {
                 to.body_mass[body] = value;
                 for (int k = 0; k < 3; ++k) to.body_inertia[3 * body + k] = inertia[static_cast<std::size_t>(k)] * value / mass;
             }});
        add({name + "_inertia_ratio", 1.0, kInertia, 0.0, 1e-9, [body](mjModel& to, double value) {
                 for (int k = 0; k < 3; ++k) to.body_inertia[3 * body + k] *= value;
             }});
    }

    /// A figure of each degree of freedom of a joint: with a tolerance, or a cause where the file has 0.
    void add_freedom(int joint, const std::string& name, mjtNum* mjModel::*values, double usual, const char* meaning, const char* remedy) {
        const int first = model_.jnt_dofadr[joint], count = freedoms_of(model_, joint);
        const double nominal = (model_.*values)[first];
        add({name, nominal, nominal > 0.0 ? kLoss : 0.0, 0.0, 0.0,
             [values, first, count](mjModel& to, double value) { std::fill_n(to.*values + first, count, value); }});
        if (!(nominal > 0.0)) own_.causes.push_back({{name}, {usual}, {0.0, kMostUsual * usual}, meaning, remedy});
    }

    void add_joint(int joint) {
        const Units& units = units_of(model_, joint);
        const std::string name = name_of(model_, mjOBJ_JOINT, joint);
        const double force = kUsualShare * usual_force(model_, joint), inertia = model_.dof_M0[model_.jnt_dofadr[joint]];
        add_freedom(joint, name + "_frictionloss_" + units.force, &mjModel::dof_frictionloss, force,
                    "A constant friction opposes this joint, and the model has none.",
                    "Look at bearings, seals and gears, or put it into the model as frictionloss.");
        add_freedom(joint, name + "_damping_" + units.loss, &mjModel::dof_damping, force / kUsualSpeed,
                    "A friction that grows with the speed opposes this joint, and the model has none.",
                    "Put it into the model as damping.");
        add_freedom(joint, name + "_armature_" + units.inertia, &mjModel::dof_armature, kUsualInertia * inertia,
                    "The rotor and its gear turn with this joint, and the model lacks their inertia.",
                    "Put rotor inertia times ratio squared into the model as armature.");
        if (model_.jnt_type[joint] != mjJNT_BALL) add_spring(joint, name, units, force / kUsualAngle);
    }

    void add_spring(int joint, const std::string& name, const Units& units, double usual) {
        const int at = model_.jnt_qposadr[joint];
        const double stiffness = model_.jnt_stiffness[joint], rest = model_.qpos_spring[at];
        const double scale = units.position == kSliding.position ? 0.1 : 1.0;
        const bool there = stiffness > 0.0;
        const std::string rate_name = name + "_stiffness_" + units.stiffness, rest_name = name + "_springref_" + units.position;
        add({rate_name, stiffness, there ? kStiffness : 0.0, 0.0, 0.0,
             [joint](mjModel& to, double value) { to.jnt_stiffness[joint] = value; }});
        add({rest_name, rest, 0.0, there ? scale * kSpringRef : 0.0, -mjMAXVAL,
             [at](mjModel& to, double value) { to.qpos_spring[at] = value; }});
        if (there) return;
        const double far = scale * mjPI;
        own_.causes.push_back({{rate_name, rest_name},
                               {usual, scale * kUsualAngle},
                               {0.0, kMostUsual * usual, std::min(rest, -far), std::max(rest, far)},
                               "A spring pulls this joint, and the model has none: a cable, a hose, a counterbalance.",
                               "Lead the cable elsewhere, or put it into the model as stiffness and springref."});
    }

    void add_actuator(int actuator) {
        const std::string name = name_of(model_, mjOBJ_ACTUATOR, actuator);
        const int gains = mjNGAIN * actuator, biases = mjNBIAS * actuator;
        const int kind = model_.actuator_trntype[actuator];
        const bool of_joint = kind == mjTRN_JOINT || kind == mjTRN_JOINTINPARENT;
        const Units& units = of_joint ? units_of(model_, model_.actuator_trnid[2 * actuator]) : kSliding;
        const double gain = model_.actuator_gainprm[gains];
        const bool affine = model_.actuator_biastype[actuator] == mjBIAS_AFFINE;
        const bool fixed = model_.actuator_gaintype[actuator] == mjGAIN_FIXED && gain != 0.0;
        const bool position = affine && fixed && model_.actuator_biasprm[biases + 1] == -gain;
        const bool speed = affine && fixed && !position && model_.actuator_biasprm[biases + 2] == -gain;
        if (fixed) {
            const int tied = position ? biases + 1 : speed ? biases + 2 : -1;  // what follows the gain: force = gain (ctrl - state)
            const std::string unit = position ? std::string("_kp_") + units.stiffness : speed ? std::string("_kv_") + units.loss : "_gain";
            add({name + unit, gain, position || speed ? kServo : kGain, 0.0, -mjMAXVAL, [gains, tied](mjModel& to, double value) {
                     to.actuator_gainprm[gains] = value;
                     if (tied >= 0) to.actuator_biasprm[tied] = -value;
                 }});
        }
        for (int k = 0; affine && k < 3; ++k)
            if (const double bias = model_.actuator_biasprm[biases + k]; bias != 0.0 && !(position && k == 1) && !(speed && k == 2))
                add({name + "_bias" + std::to_string(k), bias, kServo, 0.0, -mjMAXVAL,
                     [biases, k](mjModel& to, double value) { to.actuator_biasprm[biases + k] = value; }});
        if (model_.actuator_forcelimited[actuator] != 0) add_limit(actuator, name + "_forcerange_" + units.force);
    }

    void add_limit(int actuator, const std::string& name) {
        const double low = model_.actuator_forcerange[2 * actuator], high = model_.actuator_forcerange[2 * actuator + 1];
        if (!(high > 0.0)) return;
        add({name, high, 0.0, 0.0, 0.0, [actuator, low, high](mjModel& to, double value) {
                 to.actuator_forcerange[2 * actuator] = low * value / high;
                 to.actuator_forcerange[2 * actuator + 1] = value;
             }});
        own_.causes.push_back({{name},
                               {0.3 * high},
                               {0.01 * high, 3.0 * high},
                               "This drive saturates at another force than the model's.",
                               "Look at its current limit and supply, or put the limit into the model as forcerange."});
    }

    const mjModel& model_;
    Description own_;
};

}  // namespace

std::string name_of(const mjModel& model, mjtObj kind, int place) {
    const char* text = mj_id2name(&model, kind, place);
    std::string name = text != nullptr && *text != '\0' ? text : mju_type2Str(kind) + std::to_string(place);
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0 && c != '_' && c != '-'; }, '_');
    return name;
}

Description describe(const mjModel& model) { return Writer(model).all(); }

}  // namespace fusee::mujoco
