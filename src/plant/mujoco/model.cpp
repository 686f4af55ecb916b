#include "model.h"

#include <fmt/format.h>

#include <array>

#include "fusee/core/error.h"

namespace fusee::plant {

namespace {

constexpr double kGravity = 9.81, kLever = 0.05;  // of the mass whose weight pulls at the link [m/s^2], [m]
constexpr std::array<const char*, 2> kSides{"agonist", "antagonist"};
constexpr double kSomeFriction = 1e-6;  // a friction of 0 has no constraint: room for it is made when the model is compiled

std::string head(const Softness& s) {
    return fmt::format(R"(<mujoco><compiler angle="radian"/><option timestep="{}" solver="Newton" tolerance="1e-12" gravity="0 0 -{}"/>
<default><joint axis="0 1 0" frictionloss="{}" solreffriction="{} 1" solimpfriction="{} {} 0.001" solreflimit="{} 1" solimplimit="0.95 0.99 0.001"/>
<tendon frictionloss="{}" solreffriction="{} 1" solimpfriction="{} {} 0.001"/></default>)",
                       kMujocoStep, kGravity, kSomeFriction, s.grip_time, 1.0 - s.give, 1.0 - s.give, s.stop_time, kSomeFriction,
                       s.grip_time, 1.0 - s.give, 1.0 - s.give);
}

std::string capstan(const char* name, const SideTruth& side) {
    return fmt::format(
        R"(<body><inertial pos="0 0 0" mass="1" diaginertia="{0} {0} {0}"/><joint name="{1}" damping="{2}" limited="true" range="0 1000"/></body>)",
        side.inertia, name, side.viscous);
}

/// Pulley and link are one body, or two with play between them. The weight makes m g l; the inertia about the joint is that of the rig.
std::string link(const JointTruth& joint) {
    constexpr double kPulleyShare = 0.1, kPlayDamping = 1e-3;  // of the joint's inertia; [Nms]
    const bool stops = joint.stop<kNever, plays = joint.play> 0.0;
    const double mass = std::max(1e-6, joint.gravity / (kGravity * kLever));
    const double pulley = plays ? kPulleyShare * joint.inertia : 0.0, own = joint.inertia - mass * kLever * kLever - pulley;
    const std::string body = fmt::format(R"(<inertial pos="0 0 -{}" mass="{}" diaginertia="{} {} {}"/>)", kLever, mass, own, own, own);
    const std::string hinge = fmt::format(R"(<joint name="joint" stiffness="{}" limited="{}" range="-{} {}"/>)", joint.harness, stops,
                                          stops ? joint.stop : 1.0, stops ? joint.stop : 1.0);
    if (!plays) return "<body>" + body + hinge + "</body>";
    const std::string inner =
        fmt::format(R"(<joint name="play" limited="true" range="-{0} {0}" damping="{1}"/>)", 0.5 * joint.play, kPlayDamping);
    return fmt::format(R"(<body><inertial pos="0 0 0" mass="1e-6" diaginertia="{0} {0} {0}"/>)", pulley) + hinge + "<body>" + body + inner +
           "</body></body>";
}

std::string motor(const char* name, double lag) { return fmt::format(R"(<general joint="{}" dyntype="filter" dynprm="{}"/>)", name, lag); }

}  // namespace

Model::Model(const std::string& xml) {
    constexpr const char* kName = "rig.xml";
    std::array<char, 1000> why{};
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), kName, static_cast<int>(xml.size()));
    std::copy(xml.begin(), xml.end(), static_cast<char*>(files->filedata[0]));
    model_.reset(mj_loadXML(kName, files.get(), why.data(), static_cast<int>(why.size())));
    mj_deleteVFS(files.get());
    if (!model_) throw core::InputError("MuJoCo " + std::string(mj_versionString()) + ": " + why.data());
    data_.reset(mj_makeData(model_.get()));
}

void Model::step() {
    mj_step(model_.get(), data_.get());
    for (const mjtWarning warning : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC})
        if (data_->warning[warning].number > 0) throw core::InputError(fmt::format("MuJoCo's rig diverged at {:g} s", data_->time));
}

std::string rig_xml(const Truth& truth, const Softness& softness) {
    std::string bodies, tendons, motors, springs;
    for (std::size_t i = 0; i < 2; ++i) {
        bodies += capstan(kSides[i], truth.sides[i]);
        motors += motor(kSides[i], softness.motor_lag);
        tendons += fmt::format(R"(<fixed name="se_{0}"><joint joint="{0}" coef="1"/><joint joint="joint" coef="{1}"/></fixed>)", kSides[i],
                               (i == 0 ? 1.0 : -1.0) * truth.sides[i].ratio());
        springs += fmt::format(R"(<motor tendon="se_{}" gear="-1"/>)", kSides[i]);
    }
    for (const char* side : kSides) {
        tendons += fmt::format(R"(<fixed name="pe_{0}"><joint joint="{0}" coef="1"/></fixed>)", side);
        springs += fmt::format(R"(<motor tendon="pe_{}" gear="-1"/>)", side);
    }
    tendons += R"(<fixed name="link"><joint joint="joint" coef="1"/>)";
    tendons += truth.joint.play > 0.0 ? R"(<joint joint="play" coef="1"/></fixed>)" : "</fixed>";
    return head(softness) + "<worldbody>" + bodies + link(truth.joint) + "</worldbody><tendon>" + tendons +
           R"(</tendon><actuator><motor tendon="link"/>)" + springs + motors + "</actuator></mujoco>";
}

std::string bench_xml(const SideTruth& side, const Softness& softness) {
    return head(softness) + "<worldbody>" + capstan(kSides[0], side) + "</worldbody><actuator>" +
           fmt::format(R"(<motor joint="{}" gear="-1"/>)", kSides[0]) + motor(kSides[0], softness.motor_lag) + "</actuator></mujoco>";
}

}  // namespace fusee::plant
