// Each stage of `fusee make` alone, on K_SE and K_PE of pnrvsa, one thread:
//   cmake -S . -B build-bench -G Ninja -DFUSEE_BUILD_BENCH=ON && cmake --build build-bench --target run_bench_stage
// BM_Write and BM_ReadBack have one benchmark for each format that needs no slow program; STEP is written from a finished solid.
#include <benchmark/benchmark.h>

#include <string_view>

#include "bench_design.h"
#include "fusee/checks/check.h"
#include "fusee/core/folder.h"
#include "fusee/exchange/brep.h"
#include "fusee/exchange/part_file.h"
#include "fusee/formats/format.h"
#include "fusee/pipeline/make.h"
#include "fusee/report/report.h"
#include "fusee/solid/mesh_faults.h"
#include "fusee/solid/validity.h"

namespace fs = std::filesystem;
using namespace fusee;

namespace {

fs::path folder() {
    static const fs::path made = [] {
        fs::path path = fs::temp_directory_path() / "fusee_bench_stage";
        fs::create_directories(path);
        return path;
    }();
    return made;
}

#define STAGE(name) BENCHMARK(name)->Arg(0)->Arg(1)->ArgName("k_pe")->Unit(benchmark::kMillisecond)

void BM_Law(benchmark::State& state) {
    const profile::Profile& profile = bench::design().profile;
    for (auto _ : state) benchmark::DoNotOptimize(pipeline::resolve(profile));
}
BENCHMARK(BM_Law)->Unit(benchmark::kMillisecond);

void BM_Cam(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(pipeline::design_cam(bench::kind(state.range(0)), bench::design()));
}
STAGE(BM_Cam);

void BM_Solid(benchmark::State& state) {
    const solid::PartOptions& options = bench::part(state.range(0)).options;
    for (auto _ : state) benchmark::DoNotOptimize(solid::build_part(bench::cam(state.range(0)), options));
    state.counters["triangles"] = static_cast<double>(bench::part(state.range(0)).mesh.triangles.size());
}
STAGE(BM_Solid);

/// K_PE with a finer and finer mesh: the chordal error in nm.
void BM_SolidByError(benchmark::State& state) {
    solid::PartOptions options = bench::part(1).options;
    options.chordal_error = 1e-9 * static_cast<double>(state.range(0));
    std::size_t triangles = 0;
    for (auto _ : state) triangles = solid::build_part(bench::cam(1), options).value().mesh.triangles.size();
    state.counters["triangles"] = static_cast<double>(triangles);
    state.SetComplexityN(static_cast<std::int64_t>(triangles));
}
BENCHMARK(BM_SolidByError)->Arg(2000)->Arg(1000)->Arg(500)->Arg(200)->Unit(benchmark::kMillisecond)->Complexity();

void BM_SelfIntersection(benchmark::State& state) {
    const solid::Mesh& mesh = bench::part(state.range(0)).mesh;
    for (auto _ : state) benchmark::DoNotOptimize(solid::doubtful_triangles(mesh));
}
STAGE(BM_SelfIntersection);

void BM_Validate(benchmark::State& state) {
    const solid::Mesh& mesh = bench::part(state.range(0)).mesh;
    for (auto _ : state) benchmark::DoNotOptimize(solid::validate(mesh));
}
STAGE(BM_Validate);

void BM_Rules(benchmark::State& state) {
    const solid::Part& part = bench::part(state.range(0));
    const profile::Profile& profile = bench::design().profile;
    const profile::PartSpec& spec = bench::design().spec(part.cam.kind);
    for (auto _ : state) benchmark::DoNotOptimize(checks::check({part, spec.spring, profile.cable, profile.process, profile.limits}));
}
STAGE(BM_Rules);

void BM_ExactSolid(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(exchange::brep::build(bench::part(state.range(0))));
}
STAGE(BM_ExactSolid);

void BM_ExactSolidMirrored(benchmark::State& state) {
    const exchange::brep::Brep solid = exchange::brep::build(bench::part(state.range(0))).value();
    for (auto _ : state) benchmark::DoNotOptimize(exchange::brep::mirrored(solid));
}
STAGE(BM_ExactSolidMirrored);

/// An export of one part, its bodies made.
formats::PartExport export_of(std::int64_t number) {
    const solid::Part& part = bench::part(number);
    const profile::Profile& profile = bench::design().profile;
    formats::PartExport out{part,
                            bench::design().spec(part.cam.kind).spring,
                            {profile.name, profile.cable, profile.process, profile.machining, profile.outputs.kerf, profile.title},
                            {profile.name, profile.sha256, "bench"},
                            folder() / to_string(part.cam.kind)};
    out.mesh = part.mesh;
    return out;
}

void write(benchmark::State& state, const std::string& format) {
    formats::PartExport out = export_of(state.range(0));
    if (format == "step") out.exact = exchange::brep::build(out.part).value();
    std::uintmax_t bytes = 0;
    for (auto _ : state) {
        out.law_files.clear();
        out.other_files.clear();
        formats::write_formats(out, {format});
    }
    for (const auto* rows : {&out.law_files, &out.other_files})
        for (const formats::FileRow& row : *rows) bytes += row.bytes;
    state.counters["bytes"] = static_cast<double>(bytes);
}

void read_back(benchmark::State& state, const std::string& format) {
    formats::PartExport out = export_of(state.range(0));
    formats::write_formats(out, {format});
    std::vector<exchange::FileEntry> entries;
    for (const formats::FileRow& row : out.law_files) entries.push_back(row.entry);
    const exchange::PartFile file = exchange::describe_part(out.part, out.spring, entries, out.provenance);
    for (auto _ : state) benchmark::DoNotOptimize(formats::read_back(folder(), file));
}

/// The shop drawings and the G-code that other programs render or interpret take their time too.
[[maybe_unused]] const bool kRegistered = [] {
    for (const formats::Format& format : formats::all_formats()) {
        const std::string name = format.name;
        if (*format.note != '\0' || name == "plates") continue;
        for (const bool reads : {false, true}) {
            if (reads && format.read_back == nullptr) continue;
            const std::string title = (reads ? "BM_ReadBack/" : "BM_Write/") + name;
            benchmark::RegisterBenchmark(title.c_str(), [name, reads](benchmark::State& s) { reads ? read_back(s, name) : write(s, name); })
                ->Arg(0)
                ->Arg(1)
                ->ArgName("k_pe")
                ->Unit(benchmark::kMillisecond)
                ->UseRealTime();
        }
    }
    return true;
}();

/// The pages of a whole design.
void BM_Report(benchmark::State& state) {
    core::OutputFolder output(folder() / "made", {.command = "make", .source = bench::design().profile.file});
    profile::Profile profile = bench::design().profile;
    profile.outputs.formats = {"stl"};
    const auto made = pipeline::make_parts(profile, output);
    for (auto _ : state) report::write_design(*made, output.path());
}
BENCHMARK(BM_Report)->Unit(benchmark::kMillisecond);

}  // namespace
