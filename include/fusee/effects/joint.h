#pragma once
#include <memory>

#include "fusee/effects/effect.h"
#include "fusee/effects/menu.h"
#include "fusee/inference/model.h"
#include "fusee/joint_model/build_parameters.h"
#include "fusee/joint_model/signals.h"
#include "fusee/joint_model/uncertainty.h"

namespace fusee::effects {

/// The joint of a gap case as a model of the engine: its experiments, build parameters, effects and generic terms.
class Joint final : public inference::Model {
public:
    /// @pre the case outlives it
    explicit Joint(const gap_case::Case& gap_case);

    [[nodiscard]] const gap_case::Case& gap_case() const { return gap_case_; }
    [[nodiscard]] const joint_model::Uncertainty& known() const { return known_; }
    /// The rig of a setting, its springs tabulated.
    [[nodiscard]] joint_model::BuiltRig rig(const inference::Setting& setting) const;

    [[nodiscard]] const std::vector<inference::Experiment>& experiments() const override { return experiments_; }
    [[nodiscard]] const std::vector<inference::BuildParameter>& build() const override { return build_; }
    [[nodiscard]] const std::vector<inference::Effect>& effects() const override { return effects_; }
    [[nodiscard]] inference::Outputs predict(const inference::Setting& setting, inference::Extent extent) const override;
    /// Rigs are led together, four at a time.
    [[nodiscard]] std::vector<inference::Outputs> predict_each(const std::vector<inference::Setting>& settings,
                                                               inference::Extent extent) const override;
    [[nodiscard]] std::vector<std::string> remarks() const override;
    [[nodiscard]] inference::Form form_of(const Cause& cause, const std::vector<double>& values) const override;
    [[nodiscard]] std::unique_ptr<inference::Menu> menu() const override;

private:
    /// Gives every dead-band row what was predicted for its co-contraction.
    void repeat_levels(std::vector<double>& read) const;

    [[nodiscard]] core::Range curve_range_of(const std::string& over, const std::vector<double>& values) const;

    const gap_case::Case& gap_case_;
    joint_model::NominalCams cams_;
    joint_model::Uncertainty known_;
    std::vector<joint_model::BuildParameter> changes_;
    std::vector<inference::Experiment> experiments_;
    std::vector<inference::BuildParameter> build_;
    std::vector<inference::Effect> effects_;
    gap_case::Rows thin_;            // one repeat a level
    std::vector<std::size_t> like_;  // of each dead-band row, its row in thin_
};

/// The outcomes of a menu of the joint's measurements.
class JointMenu final : public inference::Menu {
public:
    /// @pre the joint outlives it
    JointMenu(const Joint& joint, MeasurementMenu menu);
    [[nodiscard]] const std::vector<inference::Measurement>& measurements() const override { return measurements_; }
    [[nodiscard]] std::vector<double> predict(const inference::Setting& setting) const override;
    [[nodiscard]] std::vector<double> precisions(const std::vector<double>& predicted) const override;

private:
    const Joint& joint_;
    MeasurementMenu menu_;
    std::vector<inference::Measurement> measurements_;
};

}  // namespace fusee::effects
