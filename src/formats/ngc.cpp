#include "common/tool.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/formats/format.h"
#include "fusee/readback/readers.h"
#include "fusee/toolpath/program.h"
#include "fusee/toolpath/read_back.h"

namespace fusee::formats {

namespace {

void write_programs(PartExport& out) {
    const toolpath::Settings& settings = out.settings.machining;
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

}  // namespace

Format make_ngc() {
    return {.name = "ngc",
            .extension = ".ngc",
            .meaning = "G-code by [machining]",
            .place = 9,
            .write = write_programs,
            .read_back = readback::read_program};
}

}  // namespace fusee::formats
