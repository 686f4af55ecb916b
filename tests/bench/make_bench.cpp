// The main job beside the OpenSCAD way on the same two solids at the same resolution: run with
//   cmake -S . -B build-bench -G Ninja -DFUSEE_BUILD_BENCH=ON && cmake --build build-bench --target bench
// BM_Make is the whole of `fusee make`: law, both cams, solids, rules, files, read-back, reports, for both sides of the joint. BM_OpenScad
// renders the two SCAD files that it wrote, one after the other, and nothing else. `peak_MB` is the largest resident size of this process
// up to the end of the benchmark.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <filesystem>

#include "fusee/batch/batch.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/exchange/scad.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/make.h"
#include "fusee/profile/profile.h"

namespace fs = std::filesystem;
using namespace fusee;

namespace {

fs::path out_folder() { return fs::temp_directory_path() / "fusee_bench"; }

profile::Profile paper_profile() { return profile::read_profile(fs::path(FUSEE_SOURCE_DIR) / "profiles" / "pnrvsa.toml"); }

void count_peak(benchmark::State& state) {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// The paper's profile with these formats alone, both sides of the joint.
profile::Profile with_formats(const char* formats) {
    const fs::path file = fs::path(FUSEE_SOURCE_DIR) / "profiles" / "pnrvsa.toml";
    std::string toml = core::read_file(file);
    const std::size_t begin = toml.find("formats = ["), end = toml.find(']', begin);
    return profile::parse_profile(toml.replace(begin, end + 1 - begin, std::string("formats = [") + formats + "]"), file);
}

void BM_Make(benchmark::State& state, const char* formats) {
    const profile::Profile profile = with_formats(formats);
    for (auto _ : state) {
        const auto made = batch::make(profile, {.out = out_folder()});
        if (!made.made) state.SkipWithError("the profile was refused");
    }
    count_peak(state);
}
// Beside STL alone each format alone, and all but the drawing's PDF and slicing.
#define FORMATS(name, formats) BENCHMARK_CAPTURE(BM_Make, name, formats)->Unit(benchmark::kMillisecond)->UseRealTime()->MinTime(2.0)
FORMATS(stl, "'stl'");
FORMATS(stl_3mf, "'stl', '3mf'");
FORMATS(stl_scad, "'stl', 'scad'");
FORMATS(stl_dxf, "'stl', 'dxf'");
FORMATS(stl_drawing, "'stl', 'drawing'");
FORMATS(stl_ngc, "'stl', 'ngc'");
FORMATS(stl_step, "'stl', 'step'");
FORMATS(all, "'stl', '3mf', 'scad', 'dxf', 'drawing', 'ngc', 'step'");

void BM_OpenScad(benchmark::State& state) {
    const auto made = batch::make(paper_profile(), {.out = out_folder()});
    for (auto _ : state)
        for (const char* part : {"k_se", "k_pe"})
            exchange::render_scad(made.folder / (std::string(part) + ".scad"), out_folder() / (std::string(part) + "_openscad.stl"));
}
BENCHMARK(BM_OpenScad)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

// One design of `fusee batch`: its figures alone, and with STL, SCAD and DXF of both sides, read back. Time of all threads.
profile::Profile batch_profile(bool meshes) {
    profile::Profile profile = with_formats(meshes ? "'stl', 'scad', 'dxf'" : "'stl'");
    profile.outputs.plate = false;
    return profile;
}

// Each design has a bore of its own: what is equal would be kept.
void BM_BatchFigures(benchmark::State& state) {
    profile::Profile profile = batch_profile(false);
    for (auto _ : state) {
        profile.k_se.solid.hub.bore_diameter += 1e-6;
        benchmark::DoNotOptimize(pipeline::make_figures(profile));
    }
}
BENCHMARK(BM_BatchFigures)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->MinTime(2.0);

void BM_BatchMeshes(benchmark::State& state) {
    profile::Profile profile = batch_profile(true);
    for (auto _ : state) {
        profile.k_se.solid.hub.bore_diameter += 1e-6;
        core::OutputFolder output(out_folder() / "batch", {.command = "make", .source = profile.file});
        benchmark::DoNotOptimize(pipeline::make_figures(profile, &output));
        output.commit();
    }
}
BENCHMARK(BM_BatchMeshes)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->MinTime(2.0);

// Where the time of `make` goes: law and one part's design; the rest is files, read-back and reports.
void BM_DesignLaw(benchmark::State& state) {
    const profile::Profile profile = paper_profile();
    for (auto _ : state) benchmark::DoNotOptimize(pipeline::resolve(profile));
}
BENCHMARK(BM_DesignLaw)->Unit(benchmark::kMillisecond);

void BM_DesignPart(benchmark::State& state) {
    const profile::Profile profile = paper_profile();
    const auto design = pipeline::resolve(profile);
    for (auto _ : state)
        benchmark::DoNotOptimize(pipeline::design_part(state.range(0) == 0 ? cam::PartKind::kSeries : cam::PartKind::kParallel, *design));
}
BENCHMARK(BM_DesignPart)->Arg(0)->Arg(1)->ArgName("k_pe")->Unit(benchmark::kMillisecond);

}  // namespace
