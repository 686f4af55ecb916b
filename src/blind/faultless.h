#pragma once
#include "fusee/diagnosis/diagnosis.h"
#include "fusee/gap_case/case.h"
#include "fusee/joint_model/signals.h"
#include "fusee/plant/rig.h"

/// Faultless rigs and sensors within tolerance, expressed with the public model.
namespace fusee::blind {

/// `gap_case.rig` with effects as small as tolerances, for diagnosis::predict.
struct Faultless {
    gap_case::Case gap_case;
    diagnosis::Diagnosis built;
};
/// Every nominal value changed by a normal draw of its build tolerance.
[[nodiscard]] Faultless draw_faultless(const gap_case::Case& gap_case, plant::Random& random);

/// True where an encoder reads the measured figures, else a torque sensor.
[[nodiscard]] constexpr bool is_read_by_encoder(gap_case::Experiment experiment) {
    return experiment != gap_case::Experiment::kBreakAway && experiment != gap_case::Experiment::kSpringPull;
}
/// One sigma of each measured figure: noise and step of its sensor, and of a break-away its scatter. @param exact the figures themselves
[[nodiscard]] joint_model::Signals sensor_sigma(const gap_case::Case& gap_case, const gap_case::Rows& rows,
                                                const joint_model::Signals& exact);

}  // namespace fusee::blind
