#pragma once
#include <nlohmann/json_fwd.hpp>

#include "fusee/pipeline/as_exported.h"

namespace fusee::report {

using pipeline::AsExported, pipeline::ExportedSpring, pipeline::JointAsExported;

/// `as_exported` of report.json (docs/report.md).
[[nodiscard]] nlohmann::ordered_json as_exported_json(const AsExported& exported);

}  // namespace fusee::report
