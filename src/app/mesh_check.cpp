#include "mesh_check.h"

#include <fmt/format.h>

#include <optional>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/output_folder.h"
#include "fusee/core/provenance.h"
#include "fusee/exchange/mesh_isolated.h"
#include "fusee/exchange/three_mf_coloured.h"
#include "fusee/inspect/rule.h"

namespace fusee::app {

namespace {

constexpr std::size_t kSamples = 20000;
constexpr exchange::Colour kRed = {215, 25, 28}, kOrange = {253, 174, 97};

std::string input_line(const exchange::MeshFile& file, const inspect::Body& body, const std::string& name) {
    const solid::Box& box = body.box();
    return fmt::format("{}: unit {}; {} triangles, {:.2f} x {:.2f} x {:.2f} mm, {:.4g} mm^3; {} samples", name, file.unit,
                       body.mesh().triangles.size(), box.high_mm[0] - box.low_mm[0], box.high_mm[1] - box.low_mm[1],
                       box.high_mm[2] - box.low_mm[2], solid::volume_mm3(body.mesh()), body.samples().size());
}

/// Each triangle gets the colour of its most severe finding in all processes.
void paint(std::vector<exchange::Colour>& colours, const std::vector<inspect::Marked>& found) {
    for (const core::Severity severity : {core::Severity::kWarning, core::Severity::kError})
        for (const inspect::Marked& marked : found)
            if (marked.finding.severity == severity)
                for (const std::uint32_t t : marked.triangles)
                    if (colours[t] != kRed) colours[t] = severity == core::Severity::kError ? kRed : kOrange;
}

/// @throws core::IoError naming the file if its triangles are invalid
inspect::Body body_of(solid::Mesh mesh, const std::filesystem::path& file, unsigned jobs) {
    try {
        return inspect::Body(std::move(mesh), kSamples, jobs);
    } catch (const core::InvalidInput& e) {
        throw core::IoError(file.string(), e.what());
    }
}

}  // namespace

MeshCheck check_mesh(const std::filesystem::path& path, const std::vector<Machine>& machines, const std::vector<checks::Override>& limits,
                     const std::filesystem::path& out, bool force, unsigned jobs) {
    const std::string name = path.stem().string();
    std::optional<core::OutputFolder> output;
    if (!out.empty())
        output.emplace(
            out, core::OutputRun{.command = "check", .source = path, .force = force, .files = {name + "_check.3mf"}, .many_sources = true});
    exchange::MeshFile file = exchange::read_mesh_isolated(path, {"/proc/self/exe", exchange::kReadMesh});
    const inspect::Body body = body_of(std::move(file.mesh), path, jobs);
    MeshCheck result{{name, core::sha256_hex(core::read_file(path)), input_line(file, body, path.filename().string()), {}}, {}};
    std::vector<exchange::Colour> colours(body.mesh().triangles.size(), exchange::kGrey);
    for (const Machine& machine : machines) {
        const std::vector<inspect::Marked> found = inspect::check({body, machine.process, limits}, name);
        pipeline::CheckedPart part{name, {}};
        for (const inspect::Marked& marked : found) part.findings.push_back(marked.finding);
        result.checked.processes.push_back({checks::to_string(machine.process.kind), machine.figures, machine.own, {}, {std::move(part)}});
        paint(colours, found);
    }
    if (!output) return result;
    result.coloured = out / (name + "_check.3mf");
    exchange::write_coloured_3mf(output->path() / result.coloured.filename(), body.mesh(), colours, name,
                                 core::Provenance{name, result.checked.sha256, "check"}.line());
    output->commit();
    return result;
}

}  // namespace fusee::app
