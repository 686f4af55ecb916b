#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/toolpath/program.h"
#include "fusee/toolpath/read_back.h"
#include "part_export.h"

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

void write_programs(PartExport& out) {
    if (!out.profile.outputs.ngc) return;
    const toolpath::Settings& settings = out.profile.machining;
    const auto programs = toolpath::part_programs(out.part, settings, out.provenance.line());
    if (!programs) return core::append(out.findings, programs.refusal());
    for (const toolpath::Program& program : *programs) {
        const std::filesystem::path path = out.path(program.suffix + ".ngc");
        core::write_file(path, program.text);
        out.state(path, 0, core::mm_from_m(settings.tolerance));
    }
    out.findings.push_back(unread(out.part));
}

}  // namespace fusee::pipeline
