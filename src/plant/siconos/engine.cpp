#include "siconos/engine.h"

#include <SolverOptions.h>
#include <relay_cst.h>

#include <Interaction.hpp>
#include <LagrangianDS.hpp>
#include <LagrangianLinearTIR.hpp>
#include <MoreauJeanOSI.hpp>
#include <NonSmoothDynamicalSystem.hpp>
#include <Relay.hpp>
#include <RelayNSL.hpp>
#include <SiconosException.hpp>
#include <TimeDiscretisation.hpp>
#include <TimeStepping.hpp>
#include <optional>

#include "fusee/core/error.h"

namespace fusee::plant {

namespace {

constexpr double kStep = 5e-4;  // [s]
constexpr double kEnd = 1e9;    // of the time that Siconos is told [s]
// Coordinates: both capstans, pulley; of a rig with play the link [rad].
constexpr std::size_t kPulley = 2, kLink = 3;
constexpr double kPulleyShare = 0.1;  // of the joint's inertia, where a link turns on it
using Row = std::array<double, 4>;    // d(relative angle)/d(coordinates)

[[noreturn]] void refuse(const Siconos::exception& e) {
    const std::string* why = boost::get_error_info<Siconos::exception::extra_message>(e);
    throw core::InputError("Siconos: " + (why != nullptr ? *why : "no step was found"));
}

/// A relay of Siconos: anything between its bounds that makes a relative speed 0, else a bound against this speed. Coulomb's friction, and
/// a stop that has been reached.
class Contact {
public:
    Contact(const Row& row, const SP::LagrangianDS& rig, NonSmoothDynamicalSystem& system) : law_(std::make_shared<RelayNSL>(1, 0.0, 0.0)) {
        const auto jacobian = std::make_shared<SimpleMatrix>(1, rig->dimension());
        for (unsigned j = 0; j < rig->dimension(); ++j) (*jacobian)(0, j) = row[j];
        const auto relation = std::make_shared<LagrangianLinearTIR>(jacobian, std::make_shared<SiconosVector>(1, kAlwaysClosed));
        interaction_ = std::make_shared<Interaction>(law_, relation);
        system.link(interaction_, rig);
    }
    /// Bounds of the torque along the relative angle [Nm].
    void limit(double lower, double upper) {
        law_->setLb(lower * kStep);
        law_->setUb(upper * kStep);
    }
    void rub(double friction) { limit(-friction, friction); }
    /// In the last step [Nm].
    [[nodiscard]] double torque() const { return (*interaction_->lambda(1))(0) / kStep; }

private:
    static constexpr double kAlwaysClosed = -1e6;  // Siconos looks at a law only where its gap is closed
    SP::RelayNSL law_;
    SP::Interaction interaction_;
};

/// What a stop can push [Nm] where this step would close its gap [rad], else nothing. Without rebound.
double stop_push(double gap, double opening) {
    constexpr double kAny = 1e3;
    return gap + kStep * std::min(0.0, opening) <= 0.0 ? kAny : 0.0;
}

class SiconosMotion final : public Motion {
public:
    SiconosMotion(const Truth& truth, const BuiltSprings& springs, double session);

    void run(double seconds, const std::function<Command(double)>& command) override;
    [[nodiscard]] double theta(std::size_t side) const override { return angle(side); }
    [[nodiscard]] double q() const override { return angle(link()); }
    [[nodiscard]] double joint_torque() const override { return joint_torque_; }
    [[nodiscard]] double session() const override { return drive_.session(); }

private:
    [[nodiscard]] std::size_t link() const { return truth_.joint.play > 0.0 ? kLink : kPulley; }
    [[nodiscard]] double angle(std::size_t i) const { return (*rig_->q())(static_cast<unsigned>(i)); }
    [[nodiscard]] double speed(std::size_t i) const { return (*rig_->velocity())(static_cast<unsigned>(i)); }
    double& force(std::size_t i) { return (*force_)(static_cast<unsigned>(i)); }
    void add_contacts(NonSmoothDynamicalSystem& system);
    void step(const Command& command);
    void push_side(std::size_t i, double series, const Command& command);
    void push_joint(const std::array<double, 2>& series, const Command& command);

    Truth truth_;
    Drive drive_;
    SP::LagrangianDS rig_;
    SP::SiconosVector force_;
    SP::TimeStepping simulation_;
    std::array<std::optional<Contact>, 2> gears_, series_rub_, parallel_rub_;  // rub: the hysteresis of a spring, where it has one
    std::optional<Contact> bearing_, play_;
    double joint_torque_ = 0.0;
};

SP::LagrangianDS rest(const Truth& truth) {
    const bool plays = truth.joint.play > 0.0;
    const unsigned count = plays ? 4 : 3;
    const auto mass = std::make_shared<SimpleMatrix>(count, count);
    mass->zero();
    for (unsigned i = 0; i < 2; ++i) (*mass)(i, i) = truth.sides[i].inertia;
    (*mass)(kPulley, kPulley) = (plays ? kPulleyShare : 1.0) * truth.joint.inertia;
    if (plays) (*mass)(kLink, kLink) = (1.0 - kPulleyShare) * truth.joint.inertia;
    return std::make_shared<LagrangianDS>(std::make_shared<SiconosVector>(count), std::make_shared<SiconosVector>(count), mass);
}

SiconosMotion::SiconosMotion(const Truth& truth, const BuiltSprings& springs, double session)
    : truth_(truth),
      drive_(without_hysteresis(truth), springs, session),
      rig_(rest(truth)),
      force_(std::make_shared<SiconosVector>(rig_->dimension())) {
    rig_->setFExtPtr(force_);
    const auto system = std::make_shared<NonSmoothDynamicalSystem>(0.0, kEnd);
    system->insertDynamicalSystem(rig_);
    add_contacts(*system);
    const auto relays = std::make_shared<Relay>(SICONOS_RELAY_PGS);  // the pivoting ones fail where friction and hysteresis meet
    relays->numericsSolverOptions()->dparam[SICONOS_DPARAM_TOL] = 1e-10;
    relays->numericsSolverOptions()->iparam[SICONOS_IPARAM_MAX_ITER] = 10'000;
    // 1: the new speed moves the angles, as stable as the own machine's step
    simulation_ = std::make_shared<TimeStepping>(system, std::make_shared<TimeDiscretisation>(0.0, kStep),
                                                 std::make_shared<MoreauJeanOSI>(1.0), relays);
    simulation_->setNewtonOptions(SICONOS_TS_LINEAR);
    simulation_->setCheckSolverFunction([](int failure, Simulation*) {  // Siconos only prints it
        if (failure != 0) throw core::InputError("Siconos finds no forces for a step of this rig");
    });
}

void SiconosMotion::add_contacts(NonSmoothDynamicalSystem& system) {
    for (std::size_t i = 0; i < 2; ++i) {
        const SideTruth& side = truth_.sides[i];
        Row capstan{}, cable{};
        capstan[i] = cable[i] = 1.0;
        cable[kPulley] = (i == 0 ? 1.0 : -1.0) * side.ratio();
        gears_[i].emplace(capstan, rig_, system);
        if (side.se.hysteresis > 0.0) series_rub_[i].emplace(cable, rig_, system);
        if (side.pe.hysteresis > 0.0) parallel_rub_[i].emplace(capstan, rig_, system);
    }
    bearing_.emplace(Row{0.0, 0.0, 1.0, 0.0}, rig_, system);
    if (truth_.joint.play > 0.0) play_.emplace(Row{0.0, 0.0, -1.0, 1.0}, rig_, system);
}

void SiconosMotion::push_side(std::size_t i, double series, const Command& command) {
    const SideTruth& side = truth_.sides[i];
    const double parallel = drive_.parallel(i, theta(i), kStep);
    double load = series + parallel;
    // What rubs along a cable loads the gear like the spring's pull; a step late, as the limits are.
    for (const std::optional<Contact>* rub : {&series_rub_[i], &parallel_rub_[i]})
        if (*rub) load -= (*rub)->torque();
    const double friction = drive_.gear_limit(i, load, theta(i), std::abs(speed(i)));
    gears_[i]->limit(-friction, friction + stop_push(theta(i), speed(i)));  // an unwound capstan has a stop
    if (series_rub_[i]) series_rub_[i]->rub(side.se.hysteresis * series);
    if (parallel_rub_[i]) parallel_rub_[i]->rub(side.pe.hysteresis * parallel);
    force(i) = drive_.motor(i, command.motor, theta(i)) - series - parallel - side.viscous * speed(i);
}

void SiconosMotion::push_joint(const std::array<double, 2>& series, const Command& command) {
    const JointTruth& joint = truth_.joint;
    const double arm = joint.arm_factor(angle(kPulley));
    std::array<double, 2> pulls{};
    for (std::size_t i = 0; i < 2; ++i) {
        const double rubbing = series_rub_[i] ? series_rub_[i]->torque() : 0.0;
        force(kPulley) += (i == 0 ? -arm : arm) * truth_.sides[i].ratio() * series[i];
        pulls[i] = arm * truth_.sides[i].ratio() * std::max(0.0, series[i] - rubbing);
    }
    const double friction = drive_.bearing_limit(angle(kPulley), pulls[0] + pulls[1]);
    bearing_->limit(-friction - stop_push(joint.stop - angle(kPulley), -speed(kPulley)),
                    friction + stop_push(joint.stop + angle(kPulley), speed(kPulley)));
    if (play_) {
        const double half = 0.5 * joint.play, turned = q() - angle(kPulley), turning = speed(kLink) - speed(kPulley);
        play_->limit(-stop_push(half - turned, -turning), stop_push(half + turned, turning));
    }
    force(kPulley) -= joint.viscous * speed(kPulley) + joint.harness * angle(kPulley) + joint.hardening * std::pow(angle(kPulley), 3);
    force(link()) += command.joint - command.hand * speed(link()) - fluid_drag(joint.drag, speed(link())) - joint.gravity * std::sin(q());
    joint_torque_ = command.joint;
}

void SiconosMotion::step(const Command& command) {
    const std::array<double, 2> series{drive_.series(0, theta(0), angle(kPulley), kStep),
                                       drive_.series(1, theta(1), angle(kPulley), kStep)};
    force_->zero();
    for (std::size_t i = 0; i < 2; ++i) push_side(i, series[i], command);
    push_joint(series, command);
    simulation_->computeOneStep();
    simulation_->nextStep();
    drive_.end_step(series, kStep);
}

void SiconosMotion::run(double seconds, const std::function<Command(double)>& command) {
    const long steps = std::lround(seconds / kStep);
    try {
        for (long i = 1; i <= steps; ++i) step(command(static_cast<double>(i) * seconds / static_cast<double>(steps)));
    } catch (const Siconos::exception& e) {
        refuse(e);
    }
    drive_.warm_up();
}

}  // namespace

std::unique_ptr<Motion> SiconosEngine::start(const Truth& truth, const BuiltSprings& springs, double session) const {
    try {
        return std::make_unique<SiconosMotion>(truth, springs, session);
    } catch (const Siconos::exception& e) {
        refuse(e);
    }
}

}  // namespace fusee::plant
