#include "columns.h"

namespace fusee::subsystem {

namespace {

constexpr double kMostAngle = 20.0;     // [rad], three turns
constexpr double kMostTorque = 1000.0;  // [Nm] of a motor with its gear on a bench

}  // namespace

const char* to_string(Kind kind) { return keys_of(kind).name; }

const std::vector<KindKeys>& all_keys() {
    static const std::vector<KindKeys> kKinds{
        {Kind::kFrictionElement,
         "friction_element",
         "force_loop",
         {{"t_s", false, true, false, -1e9, 1e9},
          {"x_m", false, true, false, -2.0, 2.0, "millimetres"},
          {"F_N", true, true, false, -1e9, 1e9},
          {"v_m_s", false, false, false, -10.0, 10.0, "mm/s"}},
         {{"preload_N", 0.0, 1e9, "N"}, {"coulomb_N", 1e-9, 1e9, "N"}},
         {{"force_noise_N", 1e-12, 1e9, "N"}}},
        {Kind::kServoPendulum,
         "servo_pendulum",
         "pendulum_log",
         {{"t_s", false, true, false, -1e9, 1e9},
          {"q_rad", true, true, false, -kMostAngle, kMostAngle, "degrees or counts"},
          {"q_goal_rad", false, true, false, -kMostAngle, kMostAngle, "degrees or counts"},
          {"torque_enable", false, false, false, 0.0, 1.0}},
         {{"mass_kg", 1e-6, 200.0, "kg", "grams"},
          {"length_m", 1e-4, 5.0, "m", "millimetres"},
          {"kp", 1e-6, 1e9, ""},
          {"vin_V", 0.1, 1e3, "V", "millivolts"},
          {"supply_V", 0.1, 1e3, "V", "millivolts"},
          {"supply", 0.1, 1e3, "V", "millivolts"},
          {"duty_per_kp_rad", 1e-9, 1e3, "1/rad"},
          {"kt_Nm_per_A", 1e-4, 50.0, "Nm/A", "mNm/A"},
          {"resistance_ohm", 1e-3, 1e3, "ohm", "milliohms"},
          {"armature_kgm2", 1e-9, 10.0, "kg m^2", "kg cm^2 or g cm^2"},
          {"coulomb_Nm", 1e-6, 100.0, "Nm", "mNm"},
          {"viscous_Nms", 0.0, 100.0, "Nms", "mNms"},
          {"offset_rad", -0.5, 0.5, "rad", "degrees"}},
         {{"encoder_step_rad", 1e-9, 0.1, "rad", "degrees"},
          {"encoder_noise_rad", 0.0, 0.1, "rad", "degrees"},
          {"log_rate_Hz", 0.1, 1e6, "Hz"}},
         false,
         {{"goals", {"held", "straight", "jumps"}}, {"motor", {}}}},
        {Kind::kMotorBreakaway,
         "motor_breakaway",
         "breakaway",
         {{"side", false, true, true, 0.0, 0.0},
          {"direction", false, true, true, 0.0, 0.0},
          {"motor_torque_Nm", false, true, false, 0.0, kMostTorque, "mNm"},
          {"load_torque_Nm", true, true, false, 0.0, kMostTorque, "mNm"}},
         {{"gear_load_friction", 0.0, 0.95, ""}},
         {{"breakaway_scatter", 1e-6, 1.0, ""},
          {"torque_noise_relative", 0.0, 1.0, ""},
          {"torque_noise_Nm", 0.0, kMostTorque, "Nm", "mNm"},
          {"encoder_step_rad", 0.0, 1.0, "rad"},
          {"encoder_noise_rad", 0.0, 1.0, "rad"},
          {"log_rate_Hz", 0.1, 1e6, "Hz"}}},
        {Kind::kCamJoint,
         "cam_joint",
         "pull",
         {{"t_s", false, true, false, -1e9, 1e9},
          {"q_rad", false, true, false, -kMostAngle, kMostAngle, "degrees or counts"},
          {"torque_Nm", true, true, false, -1e6, 1e6}},
         {{"dynamometer_Nm_per_rad", 1e-3, 1e12, "Nm/rad"}},
         {{"torque_noise_Nm", 1e-9, 1e6, "Nm"}},
         true},
    };
    return kKinds;
}

const KindKeys& keys_of(Kind kind) { return all_keys()[static_cast<std::size_t>(kind)]; }

}  // namespace fusee::subsystem
