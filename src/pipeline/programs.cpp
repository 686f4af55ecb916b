#include "programs.h"

#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/export.h"
#include "fusee/toolpath/read_back.h"

namespace fusee::pipeline {

namespace {

core::Finding unread(const solid::Part& part) {
    core::Finding f;
    f.rule = "readback.interpreter";
    f.what = "G-code is interpreted by LinuxCNC's rs274 and the arm recomputed from its moves";
    f.measured = toolpath::can_interpret() ? 1.0 : 0.0;
    f.bound = core::Bound::kAtLeast;
    f.allowed = 1.0;
    f.where = to_string(part.cam.kind);
    f.suggestion = "install the package linuxcnc-uspace and make again: the programs have not been read back";
    f.source = "docs/theory/toolpaths.md";
    return core::judged(f, core::Severity::kReview);
}

}  // namespace

core::Findings write_programs(const solid::Part& part, const toolpath::Settings& settings, const std::string& provenance,
                              const std::filesystem::path& base, std::vector<report::FileRow>& rows) {
    const auto programs = toolpath::part_programs(part, settings, provenance);
    if (!programs) return programs.refusal();
    for (const toolpath::Program& program : *programs) {
        const std::filesystem::path path = std::filesystem::path(base) += program.suffix + ".ngc";
        core::write_file(path, program.text);
        rows.push_back(file_row(path, 0, core::mm_from_m(settings.tolerance)));
    }
    return {unread(part)};
}

}  // namespace fusee::pipeline
