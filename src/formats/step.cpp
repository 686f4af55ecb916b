#include "fusee/exchange/step.h"

#include "fusee/checks/limits.h"
#include "fusee/formats/format.h"
#include "fusee/readback/readback.h"

namespace fusee::formats {

namespace {

/// STEP, or the finding why OpenCASCADE makes no solid of the part.
void write_exact(PartExport& out) {
    if (!out.exact) {
        auto built = exchange::brep::build(out.part);
        if (!built) return core::append(out.findings, built.refusal());
        out.exact = std::move(built).value();
    }
    const std::filesystem::path step = out.path(".step");
    const checks::Process& process = out.settings.process;
    exchange::write_step(step, *out.exact, out.name(), out.provenance.line(),
                         {checks::designation_of(process), checks::material_of(process).density});
    out.state(step, 0, out.exact->deviation_mm);
}

}  // namespace

Format make_step() {
    return {.name = "step",
            .extension = ".step",
            .meaning = "AP242",
            .place = 8,
            .by_default = always,
            .write = write_exact,
            .read_back = readback::read_step};
}

}  // namespace fusee::formats
