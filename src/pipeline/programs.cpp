#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/toolpath/program.h"
#include "fusee/toolpath/read_back.h"
#include "part_export.h"
#include "tool.h"

namespace fusee::pipeline {

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
    out.findings.push_back(
        done_by({"readback.interpreter", "G-code is interpreted by LinuxCNC's rs274 and the arm recomputed from its moves",
                 toolpath::can_interpret(), "linuxcnc-uspace", "the programs have not been read back", "docs/theory/toolpaths.md"},
                out.part));
}

}  // namespace fusee::pipeline
