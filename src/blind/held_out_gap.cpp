#include "held_out_gap.h"

#include <cmath>

#include "faultless.h"
#include "fusee/diagnosis/diagnose.h"

namespace fusee::blind {

namespace {

constexpr std::uint64_t kRigs = 401;  ///< a stream that no case is drawn from

/// Deflections and joint torques are readings too.
gap_case::Rows inputs_off(const gap_case::Case& gap_case, gap_case::Rows rows, plant::Random& random) {
    const gap_case::Sensors& s = gap_case.sensors;
    const double encoder = std::hypot(s.encoder_noise, s.encoder_step / std::sqrt(12.0));
    for (gap_case::SpringPull& row : rows.spring_pull) row.deflection += encoder * random.normal();
    for (gap_case::StiffnessRow& row : rows.joint_stiffness)
        row.joint_torque += std::hypot(s.torque_noise, s.torque_noise_relative * row.joint_torque) * random.normal();
    return rows;
}

template <typename Visit>
void visit_figures(const joint_model::Signals& signals, const Visit& visit) {
    for (const gap_case::Experiment experiment : gap_case::kAllExperiments)
        for (std::size_t i = 0; i < signals[experiment].size(); ++i) visit(experiment, i);
}

joint_model::Signals sigma_of(const gap_case::Case& gap_case, const gap_case::Rows& rows, const joint_model::Signals& nominal) {
    joint_model::Signals sigma = sensor_sigma(gap_case, rows, nominal);
    const double share = 1.0 / std::sqrt(static_cast<double>(kFaultlessRigs));
    for (int i = 0; i < kFaultlessRigs; ++i) {
        plant::Random random(0, static_cast<std::uint64_t>(i), kRigs);
        const Faultless rig = draw_faultless(gap_case, random);
        const joint_model::Signals other =
            joint_model::measured(diagnosis::predict(rig.gap_case, rig.built, inputs_off(gap_case, rows, random)));
        visit_figures(nominal, [&](gap_case::Experiment e, std::size_t k) {
            sigma[e][k] = std::hypot(sigma[e][k], share * (other[e][k] - nominal[e][k]));
        });
    }
    return sigma;
}

}  // namespace

HeldOutGap held_out_gap(const gap_case::Case& gap_case, const diagnosis::Diagnosis& found, const gap_case::Rows& rows) {
    const joint_model::Signals measured = joint_model::measured(rows),
                               nominal = joint_model::measured(diagnosis::predict(gap_case, {}, rows)),
                               after = joint_model::measured(diagnosis::predict(gap_case, found, rows)),
                               sigma = sigma_of(gap_case, rows, nominal);
    const auto gap_of = [&](const joint_model::Signals& predicted) {
        double sum = 0.0, figures = 0.0;
        visit_figures(measured, [&](gap_case::Experiment e, std::size_t i) {
            sum += std::pow((measured[e][i] - predicted[e][i]) / sigma[e][i], 2);
            ++figures;
        });
        return std::sqrt(sum / figures);
    };
    return {gap_of(nominal), gap_of(after)};
}

}  // namespace fusee::blind
