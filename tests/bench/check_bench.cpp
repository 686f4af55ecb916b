// `fusee check MESH` without its file, on a waved torus of n x n quads:
//   cmake -S . -B build-bench -G Ninja -DFUSEE_BUILD_BENCH=ON && cmake --build build-bench --target run_bench_check
// BM_CheckMesh is the whole; BM_Stage each stage alone, and BM_Rule each rule that applies, on a million triangles. The number of samples
// is fixed: their time hardly depends on the triangles.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <functional>

#include "bench_mesh.h"
#include "fusee/checks/judge.h"
#include "fusee/inspect/rule.h"
#include "fusee/solid/mesh_faults.h"

using namespace fusee;

namespace {

void BM_CheckMesh(benchmark::State& state) {
    const solid::Mesh mesh = bench::waved_torus(static_cast<std::uint32_t>(state.range(0)));
    checks::Process process;
    process.kind = static_cast<checks::ProcessKind>(state.range(1));
    for (auto _ : state) {
        const inspect::Body body(mesh);
        benchmark::DoNotOptimize(inspect::check({body, process}, "torus"));
    }
    state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
}
constexpr auto kFdm = static_cast<int>(checks::ProcessKind::kFdm), kMill4 = static_cast<int>(checks::ProcessKind::kMill4);
// 20,000, 51,000, 100,000, 500,000, 1,000,000, 2,000,000 and 5,000,000 triangles
BENCHMARK(BM_CheckMesh)
    ->ArgNames({"n", "process"})
    ->Args({100, kFdm})
    ->Args({160, kFdm})
    ->Args({160, kMill4})
    ->Args({224, kFdm})
    ->Args({500, kFdm})
    ->Args({707, kFdm})
    ->Args({1000, kFdm})
    ->Args({1581, kFdm})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

const solid::Mesh& million() {
    static const solid::Mesh mesh = bench::waved_torus(707);
    return mesh;
}

/// What they measure is in the body; `samples` 1: a body without walls and gaps.
void add_stage(const char* name, const std::function<void()>& stage) {
    benchmark::RegisterBenchmark((std::string("BM_Stage/") + name).c_str(),
                                 [stage](benchmark::State& state) {
                                     stage();  // makes the mesh and what else all share
                                     for (auto _ : state) stage();
                                 })
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime();
}

const bool kStages = [] {
    static const auto without_samples = []() -> const inspect::Body& {
        static const inspect::Body body(million(), 1);
        return body;
    };
    add_stage("edges", [] { benchmark::DoNotOptimize(inspect::topology_of(million())); });
    add_stage("tree", [] { benchmark::DoNotOptimize(inspect::Rays(million())); });
    add_stage("crossing_triangles", [] { benchmark::DoNotOptimize(solid::crossings(million(), {}, solid::kMostNearPairs, true)); });
    add_stage("holes", [] { benchmark::DoNotOptimize(inspect::find_hollows(without_samples())); });
    add_stage("all_without_samples", [] { benchmark::DoNotOptimize(inspect::Body(million(), 1)); });
    add_stage("all_with_20000_samples", [] { benchmark::DoNotOptimize(inspect::Body(million())); });
    return true;
}();

const bool kRules = [] {
    for (const auto kind : {checks::ProcessKind::kFdm, checks::ProcessKind::kMill4})
        for (const inspect::Rule& rule : inspect::rules()) {
            if (rule.of_file) continue;
            const auto measure = [kind, &rule](benchmark::State& state) {
                static const inspect::Body body(million());
                checks::Process process;
                process.kind = kind;
                for (auto _ : state) benchmark::DoNotOptimize(rule.measure({body, process}, checks::Allowed(rule, {})));
            };
            benchmark::RegisterBenchmark((std::string("BM_Rule/") + checks::to_string(kind) + "/" + rule.id).c_str(), measure)
                ->Unit(benchmark::kMillisecond)
                ->MeasureProcessCPUTime();
        }
    return true;
}();

}  // namespace
