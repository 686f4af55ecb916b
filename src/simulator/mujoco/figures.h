#pragma once
#include <mujoco/mujoco.h>

#include <functional>
#include <string>
#include <vector>

/// The companion that answers for a MuJoCo model (docs/guides/my-mujoco-model.md): a program of its own, so that fusee does not
/// link MuJoCo. SI and radians, as in the compiled model.
namespace fusee::mujoco {

/// A figure of the model file that may be another one on the rig.
struct Figure {
    std::string name;                             ///< "elbow_damping_Nms"
    double nominal = 0.0;                         ///< as in the file
    double tolerance = 0.0;                       ///< one sigma, a share of it; 0: it stays nominal unless an effect frees it
    double tolerance_abs = 0.0;                   ///< the same in its unit
    double least = 0.0;                           ///< below it the model cannot be simulated
    std::function<void(mjModel&, double)> apply;  ///< writes a value into a model that has the values of the file or of another question
};

/// An effect that the file lacks: it has the figure 0, or no bound.
struct Cause {
    std::vector<std::string> frees;  ///< the first is its id
    std::vector<double> usual;
    std::vector<double> range;  ///< low, high of each
    std::string meaning, remedy;
};

struct Description {
    std::vector<Figure> figures;  ///< to be applied in this order: of a body, the mass before the inertia
    std::vector<Cause> causes;
};

/// A name of the model as it stands in columns and figures: what is no letter, figure, _ or - is _. @returns "joint3" for the fourth,
/// unnamed
[[nodiscard]] std::string name_of(const mjModel& model, mjtObj kind, int place);

/// @throws core::InvalidInput if two of the names are one
[[nodiscard]] Description describe(const mjModel& model);

}  // namespace fusee::mujoco
