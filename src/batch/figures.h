#pragma once
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/pipeline/make.h"
#include "fusee/study/store.h"
#include "fusee/study/study.h"

namespace fusee::batch {

using Figures = decltype(study::Row::figures);

/// The columns of a study's index, in order.
[[nodiscard]] std::vector<study::Column> index_columns(const study::Plan& plan);

/// The values of the keys that vary.
[[nodiscard]] Figures varied_figures(const study::Plan& plan, const study::Planned& planned);
/// The figures of merit of a design. @param torques of the dead-bands [Nm]; empty: least, peak and overdrive torque
[[nodiscard]] Figures design_figures(const pipeline::MadeDesign& made, const std::vector<double>& torques);
/// What a design that cannot be made says: the worst finding.
[[nodiscard]] Figures finding_figures(const core::Findings& findings);

/// What is wrong with the figures of a row of the study: their names, or their kinds.
[[nodiscard]] study::RowFault row_fault(const study::Plan& plan);

}  // namespace fusee::batch
