#pragma once
#include "fusee/inference/model.h"
#include "law.h"

namespace fusee::subsystem {

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
