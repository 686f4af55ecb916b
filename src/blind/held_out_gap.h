#pragma once
#include "fusee/diagnosis/diagnosis.h"
#include "fusee/gap_case/case.h"

namespace fusee::blind {

struct HeldOutGap {
    double before = diagnosis::kNoFigure, after = diagnosis::kNoFigure;  ///< [sigma]
};
inline constexpr int kFaultlessRigs = 32;  ///< used to estimate sigma, to 12 %

/// Gap of the nominal model and of the diagnosed model on held-out measurements: root mean square of
/// (measured - predicted)/sigma over every measured figure, equally weighted. sigma^2 is that of the sensors plus the mean square by which
/// faultless rigs, drawn within tolerance and with noisy inputs, deviate from the nominal prediction
/// (docs/benchmark.md).
[[nodiscard]] HeldOutGap held_out_gap(const gap_case::Case& gap_case, const diagnosis::Diagnosis& found, const gap_case::Rows& measured);

}  // namespace fusee::blind
