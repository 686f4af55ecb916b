#include "common/tool.h"

#include <fmt/format.h>

namespace fusee::formats {

core::Finding done_by(const Tool& tool, const solid::Part& part) {
    core::Finding f;
    f.rule = tool.rule;
    f.what = tool.what;
    f.measured = tool.there ? 1.0 : 0.0;
    f.bound = core::Bound::kAtLeast;
    f.allowed = 1.0;
    f.where = to_string(part.cam.kind);
    f.suggestion = fmt::format("install the package {} and make again: {}", tool.package, tool.undone);
    f.source = tool.source;
    return core::judged(f, core::Severity::kWarning);
}

}  // namespace fusee::formats
