#include "mesh_check.h"

#include <fmt/format.h>

#include <optional>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/core/progress.h"
#include "fusee/core/provenance.h"
#include "fusee/core/text.h"
#include "fusee/exchange/mesh_file.h"
#include "fusee/exchange/three_mf.h"
#include "fusee/inspect/rule.h"
#include "fusee/profile/keys.h"

namespace fusee::app {

namespace {

constexpr exchange::Colour kRed = {215, 25, 28}, kOrange = {253, 174, 97};
constexpr std::size_t kMostLines = 12;  // of bodies

std::string size_of(const solid::Box& box) {
    return fmt::format("{:.2f} x {:.2f} x {:.2f} mm", box.high_mm[0] - box.low_mm[0], box.high_mm[1] - box.low_mm[1],
                       box.high_mm[2] - box.low_mm[2]);
}

/// The file in one line, and its bodies, if there are several, in one line each.
std::string input_lines(const std::string& unit, const inspect::File& file, const std::string& name) {
    double volume = 0.0;
    std::size_t samples = 0;
    std::string bodies;
    for (std::size_t i = 0; i < file.pieces().size(); ++i) {
        const inspect::Piece& piece = file.pieces()[i];
        const double own = solid::volume_mm3(piece.body.mesh());
        volume += own, samples += piece.body.samples().size();
        if (file.pieces().size() > 1 && i < kMostLines)
            bodies += fmt::format("\n    {}: {} triangles, {} from ({:.2f}, {:.2f}, {:.2f}) mm, {:.4g} mm^3", core::printable(piece.name),
                                  piece.triangles.size(), size_of(piece.body.box()), piece.body.box().low_mm[0], piece.body.box().low_mm[1],
                                  piece.body.box().low_mm[2], own);
    }
    if (file.pieces().size() > kMostLines) bodies += fmt::format("\n    and {} more bodies", file.pieces().size() - kMostLines);
    return fmt::format("{}: unit {}; {} triangles, {}, {:.4g} mm^3; {} samples{}", name, unit, file.triangles(), size_of(file.box()),
                       volume, samples, bodies);
}

/// Each triangle gets the colour of its most severe finding in all processes. @param numbers of the triangles in the file; empty: the same
void paint(std::vector<exchange::Colour>& colours, const std::vector<inspect::Marked>& found, const std::vector<std::uint32_t>& numbers) {
    for (const core::Severity severity : {core::Severity::kWarning, core::Severity::kError})
        for (const inspect::Marked& marked : found)
            if (marked.finding.severity == severity)
                for (const std::uint32_t t : marked.triangles) {
                    exchange::Colour& colour = colours[numbers.empty() ? t : numbers[t]];
                    if (colour != kRed) colour = severity == core::Severity::kError ? kRed : kOrange;
                }
}

/// @throws core::IoError naming the file if its triangles are invalid
inspect::File divided(solid::Mesh mesh, const std::vector<exchange::MeshItem>& items, const std::filesystem::path& file, unsigned jobs,
                      core::Progress& progress) {
    std::vector<inspect::Item> of_file;
    for (const exchange::MeshItem& item : items) of_file.push_back({core::printable(item.name), item.triangles});
    try {
        return inspect::File(std::move(mesh), std::move(of_file), inspect::File::kSamples, jobs,
                             [&progress](const std::string& stage) { progress.note(stage); });
    } catch (const core::InvalidInput& e) {
        throw core::IoError(file.string(), e.what());
    }
}

core::Findings findings_of(const std::vector<inspect::Marked>& found) {
    core::Findings findings;
    for (const inspect::Marked& marked : found) findings.push_back(marked.finding);
    return findings;
}

/// The findings of the file, and those of each body.
pipeline::CheckedProcess by_machine(const inspect::File& file, const Machine& machine, const std::vector<checks::Override>& limits,
                                    const std::string& name, std::vector<exchange::Colour>& colours) {
    pipeline::CheckedProcess checked{checks::to_string(machine.process.kind), machine.figures, machine.own, {}, {}};
    const auto whole = inspect::check({file.pieces().front().body, machine.process, limits, &file}, name);
    checked.about = findings_of(whole);
    if (!colours.empty()) paint(colours, whole, {});
    for (const inspect::Piece& piece : file.pieces()) {
        if (core::interrupted()) throw core::Stopped();
        const std::string part = piece.name.empty() ? name : name + " " + piece.name;
        const auto found = inspect::check({piece.body, machine.process, limits}, part);
        checked.parts.push_back({piece.name.empty() ? name : piece.name, findings_of(found)});
        if (!colours.empty()) paint(colours, found, piece.triangles);
    }
    return checked;
}

}  // namespace

MeshCheck check_mesh(const std::filesystem::path& path, const std::vector<Machine>& machines, const std::filesystem::path& limits_file,
                     const std::filesystem::path& out, bool force, unsigned jobs) {
    const auto limits =
        limits_file.empty() ? std::vector<checks::Override>{} : profile::read_limits(limits_file, checks::infos_of(inspect::rules()));
    const std::string name = path.stem().string();
    std::optional<core::OutputFolder> output;
    if (!out.empty())
        output.emplace(
            out, core::OutputRun{.command = "check", .source = path, .force = force, .files = {name + "_check.3mf"}, .many_sources = true});
    core::Progress progress("check " + path.filename().string(), 2 + machines.size(), core::Progress::Of::kStages);
    progress.advance("reading");
    exchange::MeshFile read = exchange::read_mesh_isolated(path, {"/proc/self/exe", exchange::kReadMesh});
    const solid::Mesh shown = output ? read.mesh : solid::Mesh{};
    progress.advance(fmt::format("{} triangles", read.mesh.triangles.size()));
    const inspect::File file = divided(std::move(read.mesh), read.items, path, jobs, progress);
    MeshCheck result{{name, core::sha256_hex(core::read_file(path)), input_lines(read.unit, file, path.filename().string()), {}}, {}};
    std::vector<exchange::Colour> colours(shown.triangles.size(), exchange::kGrey);
    for (const Machine& machine : machines) {
        progress.advance(fmt::format("rules of {}", checks::to_string(machine.process.kind)));
        result.checked.processes.push_back(by_machine(file, machine, limits, name, colours));
    }
    if (!output) return result;
    result.coloured = out / (name + "_check.3mf");
    exchange::write_coloured_3mf(output->path() / result.coloured.filename(), shown, colours, name,
                                 core::Provenance{name, result.checked.sha256, "check"}.line());
    output->commit();
    return result;
}

}  // namespace fusee::app
