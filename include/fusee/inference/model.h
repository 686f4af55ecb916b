#pragma once
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "fusee/core/units.h"

/// What the engine of diagnosis asks of a model. The engine fits, searches, holds rows out and judges; it knows no experiment, no effect
/// and no unit of a model. effects::Joint is one; a pendulum in tests/inference/pendulum.h is a small one to begin with.
namespace fusee::inference {

/// An effect and its side: "gear.coulomb" on "agonist"; "none" for an effect without sides.
struct Cause {
    std::string id, side = "none";
    [[nodiscard]] bool operator==(const Cause&) const = default;
};

/// A parameter that an effect frees.
struct EffectParameter {
    std::string name, unit;
    double scale = 1.0;              ///< usual size, in `unit`: the prior is normal with 3 of it
    core::Range allowed;             ///< hard limits
    double at_first = 0.0;           ///< start value of a further parameter
    std::vector<double> tries = {};  ///< values of a further parameter to try before a fit, in `unit`; empty: only at_first
};

/// A possible cause of a gap: parameters that the nominal model holds at "no effect".
struct Effect {
    std::string id, law;                      ///< law: one sentence with its symbols
    std::vector<std::string> sides{"none"};   ///< on each of which it is a cause of its own
    std::vector<EffectParameter> parameters;  ///< the first is its size: 0 is no effect
    std::vector<double> starts;               ///< sizes to try first, in scales of the first parameter
    std::vector<std::size_t> seen_by;         ///< experiments that it changes, as places in Model::experiments()
    std::vector<std::string> confused_with;   ///< ids of similar effects
    bool generic = false;                     ///< a form for what no effect describes: sought only where no effect explains the gap
    std::string meaning = {}, remedy = {};    ///< a sentence each for the reader; "": the reader knows its own for this id
    bool figure = false;                      ///< a figure of the model is not what was stated; rows need not show that it is right
    std::vector<double> far = {};             ///< of a limit: sizes beyond `starts` to try in this order while no run reaches them
    double least = 0.0;                       ///< a smaller size is no effect, in scales; where usual sizes are known it is kLeastSize

    /// Its size is a limit (for example the angle of a stop), which is never 0.
    [[nodiscard]] bool is_limit() const { return parameters.front().allowed.low > 0.0; }
    /// It is a ripple: its parameters are amplitude, count and phase [rad]. The opposite amplitude is the same law half a turn on.
    [[nodiscard]] bool has_phase() const { return parameters.back().name == "phase"; }
};

/// A figure of the model, fitted in every hypothesis: known within its tolerance, which is its prior, or known to nobody.
struct BuildParameter {
    std::string name, unit;
    double sigma = 1.0;       ///< of its deviation, in `unit`
    double nominal = 0.0;     ///< value at deviation 0, in `unit`
    bool of_workshop = true;  ///< false: it says how an experiment was done, and no deviation of it is impossible
    bool stated = true;       ///< false: nobody states a tolerance. Sigma is then the width of what is plausible, and the gap begins at the
                              ///< model with such figures fitted
    Cause cause = {"", ""};   ///< what a deviation far beyond its tolerance is: an effect that changes the same figure; id "": none
    double cause_size = 1.0;  ///< of that effect, in its unit, for a deviation of 1
};

/// Where a value stands in its experiment.
struct Place {
    double at = 0.0;               ///< of the experiment's variable
    std::string component, curve;  ///< what dominates a gap ("pe antagonist", "q_rad"); values that are drawn as one curve
    int block = 0;                 ///< values of one block are held out together: a run, a set point, a stretch of a path
};

/// One experiment of a model and what it measured. Its values stand row by row, in each row output by output.
struct Experiment {
    std::string name, variable;        ///< variable: of the map of the gap ("motor_torque_Nm")
    std::size_t rows = 0;              ///< 0: this case does not have it
    std::vector<std::string> outputs;  ///< names of the measured columns
    std::vector<double> measured;
    std::vector<double> sigma;  ///< expected deviation of a correct model: sensors and accuracy of the prediction, > 0
    std::vector<Place> places;  ///< of each value
    std::string blocks;         ///< what the blocks are, in the plural: "torques", "levels", "runs"
    std::string unit;           ///< of the values, if all have the same; else ""
    double weight = 1.0;        ///< share of independent values: those of a path deviate together
    double unexplained = 2.0;   ///< root mean loss of the values above which the model lacks something [sigma]
    bool direct = false;        ///< predicted without a simulation: starts of a fit are improved on it first
    [[nodiscard]] std::size_t size() const { return measured.size(); }
};

/// The values of each experiment, in their order.
using Outputs = std::vector<std::vector<double>>;

/// The parameters of one prediction.
struct Setting {
    std::vector<double> build;  ///< deviation of each build parameter from its nominal value, in its unit
    /// An effect that is on.
    struct Applied {
        Cause cause;
        std::vector<double> values;  ///< one for each parameter, in its unit, within its limits
    };
    std::vector<Applied> effects;  ///< all others are off
};

/// What a prediction has to hold.
enum class Extent {
    kAll,
    kOncePerSetPoint,  ///< repeats of a set point may be predicted by one of them: slopes and screening
    kDirect            ///< experiments with Experiment::direct; any other may be empty
};

/// The form of a generic effect with its values, for the reader.
struct Form {
    std::string port;        ///< where it enters: "gear", "motor", "joint"
    std::string depends_on;  ///< "angle", "time", "load and time"
    std::string sentence;    ///< the law with its values
    std::string x_name, y_name;
    std::vector<double> x, y;  ///< its curve
};

/// A measurement that could come next.
struct Measurement {
    std::string experiment;
    std::string what;  ///< instruction without a full stop
    std::string variable;
    std::vector<double> set_points;
    double cost = 0.0;        ///< [min]
    int repeats = 1;          ///< of each value
    std::vector<int> values;  ///< places in what Menu::predict returns
};

/// Measurements that could come next, and their outcomes.
class Menu {
public:
    virtual ~Menu() = default;
    [[nodiscard]] virtual const std::vector<Measurement>& measurements() const = 0;
    /// Values of all measurements together.
    [[nodiscard]] virtual std::vector<double> predict(const Setting& setting) const = 0;
    /// sqrt(weight)/sigma of each value, as a fit of such rows would weight it. @param predicted gives the magnitudes
    [[nodiscard]] virtual std::vector<double> precisions(const std::vector<double>& predicted) const = 0;
};

/// A setting that cannot be simulated: the hypothesis is out; no error of the program.
class Refusal : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class Model {
public:
    virtual ~Model() = default;
    [[nodiscard]] virtual const std::vector<Experiment>& experiments() const = 0;
    [[nodiscard]] virtual const std::vector<BuildParameter>& build() const = 0;
    [[nodiscard]] virtual const std::vector<Effect>& effects() const = 0;
    /// Deterministic; called by several threads at once. Every experiment has as many values as it measured (see Extent). A value that is
    /// not finite and a refusal are the same to the engine. @throws Refusal
    [[nodiscard]] virtual Outputs predict(const Setting& setting, Extent extent) const = 0;
    /// The same of several settings, in their order; empty where a setting is refused. A model overrides it where several cost less
    /// together: each has the bits that it has alone.
    [[nodiscard]] virtual std::vector<Outputs> predict_each(const std::vector<Setting>& settings, Extent extent) const;

    /// Are the usual sizes of the effects experience with such rigs? Those of a user's model are a guess.
    [[nodiscard]] virtual bool knows_usual_sizes() const { return true; }
    /// Limitations of the case, for the reader.
    [[nodiscard]] virtual std::vector<std::string> remarks() const { return {}; }
    /// The form of a generic effect. @pre the effect is generic
    [[nodiscard]] virtual Form form_of(const Cause& cause, const std::vector<double>& values) const {
        return (void)cause, (void)values, Form{};
    }
    /// Null: no further measurement is proposed.
    [[nodiscard]] virtual std::unique_ptr<Menu> menu() const { return nullptr; }
};

}  // namespace fusee::inference
