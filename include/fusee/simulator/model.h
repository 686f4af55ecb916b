#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "fusee/inference/model.h"
#include "fusee/simulator/case.h"

namespace fusee::simulator {

/// What a simulator is asked.
struct Request {
    const Experiment* experiment = nullptr;
    std::size_t run = 0;                              ///< place in experiment->runs
    const std::vector<double>* parameters = nullptr;  ///< in the order of Case::parameters
    const Columns* inputs = nullptr;                  ///< of the run, with what the ports do to them
};

/// Answers with every output of the experiment, row by row. Called by several threads at once.
/// @throws inference::Refusal if it cannot simulate these parameters; anything else ends the diagnosis
using Simulate = std::function<Columns(const Request&)>;

/// What is wrong with an answer: an output that is missing, of another length, or not finite. "": nothing
[[nodiscard]] std::string fault_of(const Columns& answer, const Request& request);

/// A case whose predictions come from a simulator. Each answer is asked for once: it is kept, and what ports do to outputs is computed
/// here.
class Simulated final : public inference::Model {
public:
    /// Asks for the nominal prediction, of the first run twice. @pre the case outlives it
    /// @throws core::InvalidInput if the simulator refuses its nominal parameters or answers the same question in two ways
    Simulated(const Case& of_case, Simulate simulate);
    ~Simulated() override;
    Simulated(const Simulated&) = delete;
    Simulated& operator=(const Simulated&) = delete;

    [[nodiscard]] const std::vector<inference::Experiment>& experiments() const override;
    [[nodiscard]] const std::vector<inference::BuildParameter>& build() const override;
    /// Those of the case; each parameter with a tolerance, whose id is its name; port.COLUMN.offset, .scale, .delay, .drift, .dead_zone.
    [[nodiscard]] const std::vector<inference::Effect>& effects() const override;
    [[nodiscard]] inference::Outputs predict(const inference::Setting& setting, inference::Extent extent) const override;
    [[nodiscard]] bool knows_usual_sizes() const override { return false; }
    [[nodiscard]] std::vector<std::string> remarks() const override;
    /// The runs again, faster or slower, or with an input at another size or place.
    [[nodiscard]] std::unique_ptr<inference::Menu> menu() const override;
    /// The same experiments with the outputs of this setting at other inputs. @throws inference::Refusal
    [[nodiscard]] std::vector<Experiment> predict_at(const inference::Setting& setting, std::vector<Experiment> inputs) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fusee::simulator
