#pragma once
#include <string>
#include <vector>

#include "fusee/simulator/model.h"

namespace fusee::simulator {

/// What could be measured next with a simulator: its runs again, each at another speed, or with one input at 0, at a multiple, or moved. A
/// change that the simulator refuses is none. The gentlest come first: of measurements that decide at the same cost the first is chosen.
class RunsAgain final : public inference::Menu {
public:
    /// @pre both outlive it
    RunsAgain(const Simulated& model, const Case& of_case);
    [[nodiscard]] const std::vector<inference::Measurement>& measurements() const override { return measurements_; }
    [[nodiscard]] std::vector<double> predict(const inference::Setting& setting) const override;
    [[nodiscard]] std::vector<double> precisions(const std::vector<double>& predicted) const override {
        return (void)predicted, precisions_;
    }

private:
    /// The first runs of an experiment, changed in one way, of which every `stride`-th row counts.
    struct Changed {
        Experiment experiment;
        std::vector<std::size_t> strides;
        std::size_t values = 0;
    };
    void add(const Experiment& changed, const std::string& column, const std::string& how);

    const Simulated& model_;
    std::vector<Changed> changed_;
    std::vector<inference::Measurement> measurements_;
    std::vector<double> precisions_;
};

}  // namespace fusee::simulator
