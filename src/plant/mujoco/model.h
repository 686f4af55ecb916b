#pragma once
#include <mujoco/mujoco.h>

#include <memory>
#include <string>

#include "mujoco/engine.h"

namespace fusee::plant {

inline constexpr double kMujocoStep = 5e-4;  ///< [s]

/// A model with its data.
class Model {
public:
    /// @throws core::InputError with MuJoCo's words
    explicit Model(const std::string& xml);
    [[nodiscard]] mjModel* operator->() { return model_.get(); }
    [[nodiscard]] mjData& data() { return *data_; }
    [[nodiscard]] const mjData& data() const { return *data_; }
    /// @throws core::InputError if the motion diverges
    void step();

private:
    struct Free {
        void operator()(mjModel* model) const { mj_deleteModel(model); }
        void operator()(mjData* data) const { mj_deleteData(data); }
    };
    std::unique_ptr<mjModel, Free> model_;
    std::unique_ptr<mjData, Free> data_;
};

/// Joints: capstan of the agonist, of the antagonist, pulley, and of a rig with play the link on the pulley. Tendons: K_SE of either side,
/// K_PE of either side, the link. Actuators: torque at the link, the four springs, the two motors.
inline constexpr std::size_t kPulley = 2, kPlay = 3, kParallel = 2, kLinkTendon = 4, kLinkTorque = 0, kSpringForce = 1, kMotor = 5;
[[nodiscard]] std::string rig_xml(const Truth& truth, const Softness& softness);
/// One capstan without springs; actuators: load, motor.
[[nodiscard]] std::string bench_xml(const SideTruth& side, const Softness& softness);

}  // namespace fusee::plant
