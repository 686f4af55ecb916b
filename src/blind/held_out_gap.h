#pragma once
#include "fusee/diagnosis/diagnosis.h"
#include "fusee/gap_case/case.h"

namespace fusee::blind {

struct HeldOutGap {
    double before = diagnosis::kNoFigure, after = diagnosis::kNoFigure;  ///< [sigma]
};
inline constexpr int kFaultlessRigs = 32;  ///< that sigma is found from: it is then known to 12 %

/// Gap of the nominal model and of the model with what was found, on measurements that the diagnosis never saw: root mean square of
/// (measured - predicted)/sigma over every measured figure, all alike. sigma^2 is that of the sensors plus the mean square by which
/// faultless rigs, drawn within tolerance and read with noise where readings are inputs, are off the nominal prediction
/// (docs/gap-benchmark.md).
[[nodiscard]] HeldOutGap held_out_gap(const gap_case::Case& gap_case, const diagnosis::Diagnosis& found, const gap_case::Rows& measured);

}  // namespace fusee::blind
