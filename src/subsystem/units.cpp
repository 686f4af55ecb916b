#include "fusee/core/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "columns.h"
#include "fusee/core/error.h"
#include "fusee/gap_case/likely_unit.h"
#include "fusee/math/statistics.h"
#include "law.h"

namespace fusee::subsystem {

namespace {

using gap_case::likely_unit;
using gap_case::OtherUnit;

constexpr double kDegrees = 180.0 / core::kPi;  // degrees of one radian
constexpr double kFar = 9.0;                    // a ratio beyond it is a unit, no cause: kgf cm for Nm would be 10.2
constexpr std::size_t kEnough = 30;             // rows for a statement on steps

const std::vector<OtherUnit> kOtherAngles{
    {kDegrees, "are these degrees"}, {1000.0, "are these milliradians"}, {4096.0 / (2.0 * core::kPi), "are these counts"}};
const std::vector<OtherUnit> kOtherTorques{{1000.0, "are these mNm"}, {100.0, "are these Ncm"}, {10.2, "are these kgf cm"}};

/// One file's figures against each other.
class Asker {
public:
    Asker(const Case& subsystem_case, const Record& record, const std::filesystem::path& folder)
        : case_(subsystem_case), record_(record), file_((folder / record.file).string()) {}

    void ask() const {
        if (const auto* t = column("t_s")) ask_times(*t);
        if (const auto* q = column("q_rad")) ask_angles("q_rad", *q);
        switch (case_.kind) {
            case Kind::kServoPendulum:
                return ask_servo();
            case Kind::kFrictionElement:
                return ask_element();
            case Kind::kMotorBreakaway:
                return ask_motor();
            case Kind::kCamJoint:
                return;  // against its law: require_same_units (pull.h)
        }
    }

private:
    [[nodiscard]] core::InvalidInput fault(const std::string& name, std::string value, std::string allowed) const {
        return {file_ + ": " + name, std::move(value), std::move(allowed)};
    }
    [[nodiscard]] const std::vector<double>* column(const char* name) const {
        const auto at = record_.columns.find(name);
        return at == record_.columns.end() || at->second.empty() ? nullptr : &at->second;
    }
    // NaN: not given, every comparison is false
    [[nodiscard]] double number(const char* name) const { return number_or(record_.parameters, name, std::nan("")); }
    [[nodiscard]] double sensor(const char* name) const { return number_or(case_.sensors, name, std::nan("")); }
    [[nodiscard]] double supply_of_motor() const {  // [V], under one of its names
        return number_or(record_.parameters, "vin_V", number_or(record_.parameters, "supply_V", number("supply")));
    }
    [[nodiscard]] static double largest(const std::vector<double>& values) {
        double most = 0.0;
        for (const double value : values) most = std::max(most, std::abs(value));
        return most;
    }
    [[nodiscard]] static double travel(const std::vector<double>& values) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        return *high - *low;
    }

    void ask_times(const std::vector<double>& t) const {
        constexpr double kNear = 0.05, kServoStep = 0.5, kLoggedStep = 1.0, kByHand = 60.0;  // [s]
        constexpr std::size_t kLogged = 200;                                                 // rows: nobody reads so many by hand
        if (t.size() < 3) return;
        std::vector<double> steps;
        for (std::size_t i = 1; i < t.size(); ++i) steps.push_back(t[i] - t[i - 1]);
        const double step = math::upper_median(std::move(steps)), rate = sensor("log_rate_Hz");
        const std::vector<OtherUnit> units{{1e3, "are these milliseconds"}, {1e6, "are these microseconds"}};
        const std::string value = fmt::format("a row every {:g} s", step);
        for (const OtherUnit& unit : units)
            if (std::abs(step * rate / unit.count - 1.0) < kNear)
                throw fault("t_s", value,
                            fmt::format("seconds: {:g} Hz in [sensors] would be {:g} s; {}?", rate, 1.0 / rate, unit.question));
        const double most = case_.kind == Kind::kServoPendulum ? kServoStep : t.size() >= kLogged ? kLoggedStep : kByHand;
        if (step > most)
            throw fault("t_s", value, fmt::format("seconds, with a row every {:g} s at least{}", most, likely_unit(step / 0.01, units)));
    }

    /// Readings of an encoder are multiples of its step: in degrees of another one.
    void ask_angles(const char* name, const std::vector<double>& q) const {
        constexpr int kFewestBits = 8, kMostBits = 16;
        constexpr double kNear = 0.003;
        if (q.size() < kEnough) return;
        const double stated = sensor("encoder_step_rad"), step = gap_case::step_of(q);
        for (const OtherUnit& unit : kOtherAngles)
            if (stated > 0.0 && gap_case::counted_in(q, unit.count * stated))
                throw fault(name, fmt::format("multiples of {:.4g}", unit.count * stated),
                            fmt::format("radians, with the encoder's step of {:.4g} rad; {}?", stated, unit.question));
        if (stated > 0.0 && gap_case::counted_in(q, stated / kDegrees) && std::abs(step * kDegrees / stated - 1.0) < kNear)
            throw fault("sensors.encoder_step_rad", fmt::format("{:g}", stated),
                        fmt::format("radians: the readings have a step of {:.4g} rad; is it in degrees?", step));
        if (step <= 0.0 || !gap_case::counted_in(q, step)) return;
        if (std::abs(step - 1.0) < kNear) throw fault(name, "whole numbers", "radians; are these counts?");
        for (int bits = kFewestBits; bits <= kMostBits; ++bits)
            if (std::abs(step * std::ldexp(1.0, bits) / 360.0 - 1.0) < kNear)
                throw fault(name, fmt::format("multiples of {:.4g}", step),
                            fmt::format("radians; an encoder of {} bits has a step of {:.4g} degrees: are these degrees?", bits, step));
    }

    void ask_servo() const {
        const auto *q = column("q_rad"), *goal = column("q_goal_rad");
        if (q != nullptr && goal != nullptr) ask_goals(*q, *goal);
        ask_weight();
        if (q != nullptr) ask_speed(*q);
    }

    /// Goals in another unit than the readings.
    void ask_goals(const std::vector<double>& q, const std::vector<double>& goal) const {
        constexpr double kNear = 0.25;
        const double ratio = travel(goal) / travel(q);
        if (!std::isfinite(ratio) || (ratio < kFar && ratio > 1.0 / kFar)) return;
        for (const OtherUnit& unit : kOtherAngles)
            for (const bool of_goal : {true, false})
                if (std::abs((of_goal ? ratio : 1.0 / ratio) / unit.count - 1.0) < kNear)
                    throw fault(of_goal ? "q_goal_rad" : "q_rad",
                                fmt::format("{:.3g} times the travel of the other", of_goal ? ratio : 1.0 / ratio),
                                fmt::format("radians, as {}; {}?", of_goal ? "q_rad" : "q_goal_rad", unit.question));
    }

    /// The weight against what the servo lifts.
    void ask_weight() const {
        constexpr double kLift = 0.1;     // [Nm/V^2], twice that of the strongest small servos: kt/R kt-fold
        constexpr double kMuch = 1000.0;  // a stall torque over the weight, or an inertia over the load's
        constexpr double kLongArm = 1.5;  // [m]
        const double mass = number("mass_kg"), length = number("length_m"), weight = mass * 9.81 * length;
        const double supply = supply_of_motor();
        const double stall = number("kt_Nm_per_A") * supply / number("resistance_ohm");
        const double most = stall > 0.0 ? 5.0 * stall : kLift * supply * supply;
        if (weight > most)
            throw fault(length > kLongArm ? "length_m" : "mass_kg", fmt::format("{:g} kg at {:g} m: {:.3g} Nm", mass, length, weight),
                        fmt::format("a weight that the servo moves, {:.3g} Nm {}; {}?", most,
                                    stall > 0.0 ? "with kt_Nm_per_A and resistance_ohm as given" : fmt::format("at {:g} V", supply),
                                    length > kLongArm ? "is the length in millimetres" : "is the mass in grams, or kt in another unit"));
        if (stall > kMuch * weight)
            throw fault("kt_Nm_per_A", fmt::format("{:g}, a stall torque of {:.3g} Nm", number("kt_Nm_per_A"), stall),
                        fmt::format("Nm/A for a weight of {:.3g} Nm; is it in mNm/A?", weight));
        const double friction = number("coulomb_Nm"), armature = number("armature_kgm2");
        if (friction > kFar * std::fmax(weight, stall))
            throw fault("coulomb_Nm", fmt::format("{:g}", friction), fmt::format("Nm, for a weight of {:.3g} Nm; are these mNm?", weight));
        if (armature > kMuch * mass * length * length)
            throw fault("armature_kgm2", fmt::format("{:g}", armature),
                        fmt::format("kg m^2, where the load has {:.3g}; are these kg cm^2 or g cm^2?", mass * length * length));
    }

    /// The speed against that of the motor without load.
    void ask_speed(const std::vector<double>& q) const {
        constexpr double kMargin = 3.0;
        constexpr std::size_t kSpan = 5;
        const double supply = supply_of_motor();
        const double most = supply / number("kt_Nm_per_A");
        const auto* t = column("t_s");
        if (!(most > 0.0) || t == nullptr || q.size() < kEnough) return;
        std::vector<double> speeds;
        for (std::size_t i = kSpan; i < q.size(); ++i) speeds.push_back(std::abs(q[i] - q[i - kSpan]) / ((*t)[i] - (*t)[i - kSpan]));
        std::nth_element(speeds.begin(), speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() * 19 / 20), speeds.end());
        const double speed = speeds[speeds.size() * 19 / 20];
        if (speed > kMargin * most)
            throw fault("kt_Nm_per_A", fmt::format("{:g}: {:.3g} rad/s at most", number("kt_Nm_per_A"), most),
                        fmt::format("Nm/A that let the arm move at {:.3g} rad/s, as it does{}", speed,
                                    likely_unit(speed / most, {{1000.0, "is it in mNm/A"}, {kDegrees, "or are the angles degrees"}})));
    }

    void ask_element() const {
        const auto *t = column("t_s"), *x = column("x_m"), *v = column("v_m_s"), *force = column("F_N");
        constexpr double kMostAmplitude = 1.0, kMostSpeed = 5.0;  // [m], [m/s] of a slow test of friction
        double path = 0.0;
        for (std::size_t i = 1; i < x->size(); ++i) path += std::abs((*x)[i] - (*x)[i - 1]);
        const double speed = t->size() > 1 ? path / (t->back() - t->front()) : 0.0;
        if (0.5 * travel(*x) > kMostAmplitude || speed > kMostSpeed)
            throw fault("x_m", fmt::format("an amplitude of {:.3g} m, {:.3g} m/s on average", 0.5 * travel(*x), speed),
                        fmt::format("metres, at most {:g} m and {:g} m/s; are these millimetres?", kMostAmplitude, kMostSpeed));
        if (v != nullptr && x->size() >= kEnough) {
            double sum = 0.0;
            for (const double each : *v) sum += std::abs(each);
            const double ratio = sum / static_cast<double>(v->size()) / speed;
            if (speed > 0.0 && (ratio > kFar || ratio < 1.0 / kFar))
                throw fault(
                    "v_m_s", fmt::format("{:.3g} times the speed of x_m over t_s", ratio),
                    "m/s, as x_m in m over t_s in s" + likely_unit(ratio, {{1000.0, "are the speeds mm/s, or the times milliseconds"},
                                                                           {0.001, "are the displacements millimetres"}}));
        }
        if (force != nullptr && largest(*force) < sensor("force_noise_N"))
            throw fault("F_N", fmt::format("at most {:.3g}", largest(*force)),
                        fmt::format("newtons, above the noise of {:.3g} N in [sensors]; are these kN?", sensor("force_noise_N")));
        if (force != nullptr && largest(*force) > 0.0 && std::abs(std::log10(number("coulomb_N") / largest(*force))) > 2.0)
            throw fault("coulomb_N", fmt::format("{:g}", number("coulomb_N")),
                        fmt::format("a friction in N of the order of F_N, at most {:.3g}; are F_N or coulomb_N in kN?", largest(*force)));
    }

    void ask_motor() const {
        constexpr double kMuchLoad = 25.0;      // over the motor torque: a friction of 0.95 of the load makes 20 of it
        constexpr double kFinestSensor = 1e-5;  // of its range
        const auto *motor = column("motor_torque_Nm"), *load = column("load_torque_Nm");
        if (motor != nullptr && sensor("torque_noise_Nm") > 0.0 && sensor("torque_noise_Nm") < kFinestSensor * largest(*motor))
            throw fault("motor_torque_Nm", fmt::format("up to {:.3g}", largest(*motor)),
                        fmt::format("Nm, with a noise of {:.3g} Nm in [sensors]; are these mNm?", sensor("torque_noise_Nm")));
        if (motor == nullptr || load == nullptr) return;
        double loads = 0.0, motors = 0.0;
        for (std::size_t i = 0; i < motor->size(); ++i) loads += std::abs((*load)[i]), motors += std::abs((*motor)[i]);
        if (loads > kMuchLoad * motors)
            throw fault("load_torque_Nm", fmt::format("{:.3g} times the motor torques", loads / motors),
                        "Nm at the same shaft as the motor torques" + likely_unit(loads / motors, kOtherTorques));
        if (loads > 0.0 && motors > kMuchLoad * loads)
            throw fault("motor_torque_Nm", fmt::format("{:.3g} times the loads", motors / loads),
                        "Nm at the same shaft as the loads" + likely_unit(motors / loads, kOtherTorques));
    }

    const Case& case_;
    const Record& record_;
    std::string file_;
};

}  // namespace

void ask_units(const Case& subsystem_case, const std::filesystem::path& folder) {
    for (const Record& record : subsystem_case.records) Asker(subsystem_case, record, folder).ask();
}

}  // namespace fusee::subsystem
