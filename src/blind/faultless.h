#pragma once
#include "fusee/gap/case.h"
#include "fusee/gap/diagnosis.h"
#include "fusee/gap/signals.h"
#include "fusee/plant/random.h"

/// Rigs of the model, and sensors, that are off by no more than they may be, said with nothing but the public model.
namespace fusee::blind {

/// `bench.rig` with effects as small as tolerances, for gap::predict.
struct Faultless {
    gap::Case bench;
    gap::Diagnosis built;
};
/// Every nominal figure off by a normal draw of its build tolerance.
[[nodiscard]] Faultless draw_faultless(const gap::Case& bench, plant::Random& random);

/// True where an encoder reads the measured figures, else a torque sensor.
[[nodiscard]] constexpr bool is_read_by_encoder(gap::Experiment experiment) {
    return experiment != gap::Experiment::kBreakAway && experiment != gap::Experiment::kSpringPull;
}
/// One sigma of each measured figure: noise and step of its sensor, and of a break-away its scatter. @param exact the figures themselves
[[nodiscard]] gap::Signals sensor_sigma(const gap::Case& bench, const gap::Rows& rows, const gap::Signals& exact);

}  // namespace fusee::blind
