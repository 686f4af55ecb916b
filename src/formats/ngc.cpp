#include "common/mill_check.h"
#include "common/tool.h"
#include "fusee/checks/limits.h"
#include "fusee/core/file.h"
#include "fusee/core/units.h"
#include "fusee/readback/readback.h"
#include "fusee/toolpath/read_back.h"

namespace fusee::formats {

namespace {

/// What speeds and feeds are for: the material of the process, whatever the process is.
toolpath::Stuff stuff_of(const checks::Process& process) {
    const std::string name = checks::material_of(process).name;
    if (name.find("steel") != std::string::npos) return toolpath::Stuff::kSteel;
    if (name.find("brass") != std::string::npos) return toolpath::Stuff::kBrass;
    return name.find("aluminium") != std::string::npos ? toolpath::Stuff::kAluminium : toolpath::Stuff::kPlastic;
}

void write_programs(PartExport& out) {
    toolpath::Settings settings = out.settings.machining;
    settings.stuff = out.settings.machining.stuff = stuff_of(out.settings.process);
    settings.blend = core::m_from_mm(out.part.chordal_error_mm);
    const auto programs = toolpath::part_programs(out.part, settings, out.provenance.line());
    if (!programs) return core::append(out.findings, programs.refusal());
    for (const toolpath::Program& program : *programs) {
        const std::filesystem::path path = out.path(program.suffix + ".ngc");
        core::write_file(path, program.text);
        out.state(path, 0, core::mm_from_m(settings.tolerance));
        core::append(out.findings, program.findings);
    }
    const std::vector<Milled> all = mill(out, *programs);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::filesystem::path sheet = out.path((*programs)[i].suffix + "_setup.md");
        core::write_file(sheet, setup_sheet(all[i], out));
        out.other_files.push_back(file_row(sheet));
        core::append(out.findings, all[i].findings);
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
