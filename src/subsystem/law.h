#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "fusee/subsystem/subsystem.h"

/// A bench's law: what it predicts from its inputs, with a number for each nominal parameter and for each parameter of each effect.
namespace fusee::subsystem {

struct Parameter {
    std::string name, unit;
    double null_value = 0.0;  ///< the value without its effect; a nominal parameter's start
    double low = 0.0, high = 0.0;
    std::vector<double> starts;  ///< an effect's: where fits begin; the best end counts
};
using Values = std::vector<double>;  ///< one for each parameter

/// An effect and its parameters; the first is the parameter that a diagnosis gives.
struct LawEffect {
    effects::Cause cause;
    std::vector<std::size_t> parameters;
    bool moves_setups = false;  ///< makes files of the same motion differ: the floor from set-up to set-up is no argument against it
    std::string unseen;         ///< why this case cannot show it; empty: it can
};

/// How files may be held out together, e.g. by "kp": a label for each block.
struct Scheme {
    std::string name;
    std::vector<std::string> labels;
};
/// Rows that are held out together at least: a file, a part of the only one, a motor torque.
struct Block {
    std::string name;
    std::size_t record = 0;
    std::vector<std::size_t> rows;  ///< of the record's rows in use
};

/// What one file offers to a fit.
struct Target {
    std::vector<double> measured, sigma;
    std::vector<bool> settled;   ///< rows that count; empty: all
    std::vector<double> region;  ///< the variable over which the gap is mapped
    std::string group;           ///< its name in `where`
};

class Law {
public:
    virtual ~Law() = default;
    /// Of the measured column, every row in use of one record. Reentrant.
    virtual void predict(std::size_t record, const Values& values, std::vector<double>& predicted) const = 0;
    /// What else a user should know after the fit: parameters that the bench cannot part, ...
    [[nodiscard]] virtual std::vector<std::string> remarks() const { return {}; }
    /// A measurement that would tell the rest of the alternatives apart, and one that would show what this case cannot.
    [[nodiscard]] virtual diagnosis::NextExperiment next() const = 0;

    std::string measured_name, region_name, unit;  ///< unit of the measured column
    double unit_sigma = 1.0;                       ///< a typical sigma in `unit`: turns a gap in sigma into one in unit
    std::vector<Parameter> parameters;
    std::size_t nominal = 0;  ///< the first so many parameters are the nominal law's
    std::vector<LawEffect> effects;
    std::size_t most_effects = 2;  ///< in one hypothesis
    std::vector<Target> targets;   ///< one for each record
    std::vector<Block> blocks;
    std::vector<Scheme> schemes;  ///< the first holds out one block at a time
    double cycle_floor = 1.0;     ///< scatter from cycle to cycle, or of the sensor [sigma]
    double setup_floor = 1.0;     ///< from one file to the next of the same motion, at least cycle_floor [sigma]
    std::vector<std::string> floor_remarks;
    bool rows_independent = false;  ///< each row is a measurement of its own: no autocorrelation to allow for
};

/// The law of a case; `for_inputs`: only `predict` will be used, measured columns may be absent.
[[nodiscard]] std::unique_ptr<Law> law_of(const Case& subsystem_case, bool for_inputs = false);
[[nodiscard]] std::unique_ptr<Law> friction_element(const Case& subsystem_case, bool for_inputs);
[[nodiscard]] std::unique_ptr<Law> servo_pendulum(const Case& subsystem_case, bool for_inputs);
[[nodiscard]] std::unique_ptr<Law> motor_breakaway(const Case& subsystem_case, bool for_inputs);

/// A number of the record, one of several names. @throws core::InvalidInput naming the file and the first name if none stands there
[[nodiscard]] double number_of(const Record& record, const std::vector<std::string>& names);
/// Blocks of whole files; of three parts in time of each if there are fewer than three files. With the scheme "file" or "part".
void make_blocks(Law& law, const Case& subsystem_case);
/// Adds a scheme that holds out together what shares a label, if there are two labels or more and they part the blocks otherwise than the
/// schemes that are there.
void add_scheme(Law& law, const std::string& name, const std::vector<std::string>& label_of_record);

}  // namespace fusee::subsystem
