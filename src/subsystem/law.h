#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fusee/inference/model.h"
#include "fusee/subsystem/subsystem.h"

/// Law of a subsystem: prediction from its inputs, with a value for each nominal parameter and for each parameter of each effect.
namespace fusee::subsystem {

/// Which ends of a range belong to the quantity, as no friction or a share of 1: a fit may rest there. At any other end the search has
/// stopped, and the value is no finding.
enum class OwnEnds { kNone, kLow, kBoth };

struct Parameter {
    std::string name, unit;
    double null_value = 0.0;  ///< the value without its effect; the start of a nominal parameter
    double low = 0.0, high = 0.0;
    std::vector<double> starts;  ///< starts of the fits, of which the best counts; of a nominal one: of the nominal law's
    double prior = 0.0;          ///< deviation of plausible values about the null value; 0: any value is
    OwnEnds own_ends = OwnEnds::kNone;
    double usual = 0.0;  ///< range in which it usually lies: measures a fit's steps; 0: high - low
    [[nodiscard]] double range() const { return usual > 0.0 ? usual : high - low; }
    /// The search stopped at `value`. A low end that is the null value counts as an end of the quantity.
    [[nodiscard]] bool stops_at(double value) const;
};
using Values = std::vector<double>;  ///< one for each parameter

/// An effect and its parameters; the first is the size in a diagnosis.
struct LawEffect {
    effects::Cause cause;
    std::vector<std::size_t> parameters;
    bool moves_setups = false;  ///< makes files of the same motion differ: the set-up floor does not refuse it
    std::string unseen;         ///< reason why this case cannot show it; empty: it can
    std::string figures = {};   ///< of the case, of which one is wrong where the size has no end; empty: none is known
};

/// What the case leaves open about its inputs: each choice is tried as a whole, and the rows decide.
struct OpenInput {
    std::size_t parameter = 0;                            ///< holds the choice
    std::vector<std::pair<double, const char*>> choices;  ///< its values and their names, at least two
    const char* key = "";                                 ///< of the case, which would have told
};

/// Which blocks are held out together, e.g. by "kp": a label for each block.
struct Scheme {
    std::string name;
    std::vector<std::string> labels;
};
/// Blocks of one label of a scheme.
struct Fold {
    std::string label;
    std::vector<std::size_t> blocks;
};
/// In the order of the labels' first blocks.
[[nodiscard]] std::vector<Fold> folds_of(const Scheme& scheme);

/// Rows that are always held out together: a file, a part of the only file, a motor torque.
struct Block {
    std::string name;
    std::size_t record = 0;
    std::vector<std::size_t> rows;  ///< of the record's rows in use
};

/// Data of one file for a fit.
struct Target {
    std::vector<double> measured, sigma;
    std::vector<bool> settled;   ///< rows that count; empty: all
    std::vector<double> region;  ///< variable of the gap map
    std::string group;           ///< its name in `where`
};

class Law {
public:
    virtual ~Law() = default;
    /// Predicts the measured column, every row in use of one record. Reentrant.
    virtual void predict(std::size_t record, const Values& values, std::vector<double>& predicted) const = 0;
    /// Remarks after the fit, e.g. on parameters that the case cannot distinguish.
    [[nodiscard]] virtual std::vector<std::string> remarks() const { return {}; }
    /// The measurement that distinguishes the remaining alternatives, and the one that shows what this case cannot.
    [[nodiscard]] virtual diagnosis::NextExperiment next() const = 0;
    /// The measurement that tells sets of effects apart that predict the rows equally well; `open`: what some of these sets hold and others
    /// do not; empty: there are no such sets. "": next() says it.
    [[nodiscard]] virtual std::string split(const std::vector<std::size_t>& open) const { return (void)open, ""; }

    std::string measured_name, region_name, unit;  ///< unit of the measured column
    double unit_sigma = 1.0;                       ///< a typical sigma in `unit`: converts a gap in sigma
    std::vector<Parameter> parameters;
    std::size_t nominal = 0;  ///< the first so many parameters are the nominal law's
    std::vector<LawEffect> effects;
    std::optional<OpenInput> open_input = {};
    std::vector<std::vector<std::size_t>> own = {};  ///< of each record: parameters of it alone, as a sensor's zero: the rows of a record
                                                     ///< that is held out as a whole fit them too. Empty: none
    std::size_t most_effects = 3;                    ///< in one hypothesis
    std::size_t whole_sets = 3;                      ///< every set of so many effects is fitted; larger ones upon the best of these
    std::vector<Target> targets;                     ///< one for each record
    std::vector<Block> blocks;
    std::vector<Scheme> schemes;  ///< the first holds out one block at a time
    double cycle_floor = 1.0;     ///< scatter from cycle to cycle, or of the sensor [sigma]
    double setup_floor = 1.0;     ///< from one file to the next of the same motion, at least cycle_floor [sigma]
    std::vector<std::string> floor_remarks;
    std::vector<std::string> same_rows = {};  ///< ids of effects that change the rows of any test alike: none of them is certain
    std::vector<std::string> defaults = {};   ///< in place of what the case does not give, where they decide the answer: one sentence each
    std::string default_sigma = {};           ///< the same for sigma; it decides nothing where the fit leaves just as much
    bool exact = false;                       ///< sigma is all that rows deviate by, each alone: the engine diagnoses it (LawModel)
    bool each_fold = false;      ///< few files that differ in their law: of a split in two, an effect must lower the error of both halves
    bool many_minima = false;    ///< of the cost, as rollouts have: fits without held-out rows begin from all starts, too
    bool weighs_equals = false;  ///< sets of effects that predict the rows equally well share the probability
    bool over_region = false;    ///< charts over the region's variable, not over time
};

[[nodiscard]] std::vector<std::size_t> all_blocks(const Law& law);
/// The other blocks.
[[nodiscard]] std::vector<std::size_t> blocks_without(const Law& law, const std::vector<std::size_t>& some);
/// The set without each of its effects, in their order.
[[nodiscard]] std::vector<std::vector<std::size_t>> subsets_of(const std::vector<std::size_t>& set);

/// The law of a case; with `inputs`, for `predict` only: of these files, whose measured columns may be absent, with the case's parameters.
[[nodiscard]] std::unique_ptr<Law> law_of(const Case& subsystem_case, const Case* inputs = nullptr);
[[nodiscard]] std::unique_ptr<Law> friction_element(const Case& subsystem_case, bool for_inputs);
[[nodiscard]] std::unique_ptr<Law> servo_pendulum(const Case& subsystem_case, bool for_inputs);
[[nodiscard]] std::unique_ptr<Law> motor_breakaway(const Case& subsystem_case, bool for_inputs);
[[nodiscard]] std::unique_ptr<Law> cam_joint(const Case& subsystem_case, const Case* inputs);

/// Long loops call it. @throws core::Stopped after Ctrl-C or SIGTERM
void stop_if_asked();
/// 1, or so much that every so many-th row of all records together is at most 12,000: loops keep their shape, a fit ends in time.
[[nodiscard]] std::size_t thinning(const std::vector<Record>& records);
/// Every `step`-th number, the first one too.
[[nodiscard]] std::vector<double> every(const std::vector<double>& column, std::size_t step);
/// Scatter of a row about the straight line through its neighbours: that of the sensor where the column changes slowly.
[[nodiscard]] double scatter_of(const std::vector<double>& column);
/// The number of this name, or `otherwise`.
[[nodiscard]] double number_or(const std::map<std::string, double>& numbers, const char* name, double otherwise);
/// A number of the record under one of several names. @throws core::InvalidInput naming the file and the first name if there is none
[[nodiscard]] double number_of(const Record& record, const std::vector<std::string>& names);
/// Blocks of whole files; of three parts in time of each if there are fewer than `least_files`. With the scheme "file" or "part".
void make_blocks(Law& law, const Case& subsystem_case, std::size_t least_files = 3);
/// Adds a scheme that holds out blocks by label, if there are two labels or more and the split differs from the
/// existing schemes.
void add_scheme(Law& law, const std::string& name, const std::vector<std::string>& label_of_record);

/// A law as a model of the engine of diagnosis: its nominal parameters are figures that nobody states, a group of files is an experiment.
class LawModel final : public inference::Model {
public:
    /// @pre the law outlives it
    explicit LawModel(const Law& law);
    [[nodiscard]] const std::vector<inference::Experiment>& experiments() const override { return experiments_; }
    [[nodiscard]] const std::vector<inference::BuildParameter>& build() const override { return build_; }
    [[nodiscard]] const std::vector<inference::Effect>& effects() const override { return effects_; }
    [[nodiscard]] inference::Outputs predict(const inference::Setting& setting, inference::Extent extent) const override;
    [[nodiscard]] std::vector<std::string> remarks() const override;
    /// Of a value for each parameter of the law.
    [[nodiscard]] inference::Outputs outputs(const Values& values) const;

private:
    void add_experiments();
    void add_effect(const LawEffect& effect);

    const Law& law_;
    std::vector<inference::Experiment> experiments_;
    std::vector<std::size_t> experiment_of_;  ///< of each block
    std::vector<inference::BuildParameter> build_;
    std::vector<inference::Effect> effects_;
};

}  // namespace fusee::subsystem
