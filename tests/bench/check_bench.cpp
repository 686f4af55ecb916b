// `fusee check MESH` without its file: topology, 20000 samples, every rule of a process. A torus of n x n quads with a finely waved
// surface, so that no two triangles are alike. `samples` fixes the work per process, so the time grows with the tree only.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>

#include "fusee/inspect/rule.h"

using namespace fusee;

namespace {

solid::Mesh waved_torus(std::uint32_t n) {
    solid::Mesh mesh;
    const double step = 2.0 * 3.141592653589793 / n;
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
            const double u = i * step, v = j * step, r = 12.0 + 0.2 * std::sin(7 * u) * std::cos(5 * v);
            mesh.points_mm.push_back({(40 + r * std::cos(v)) * std::cos(u), (40 + r * std::cos(v)) * std::sin(u), r * std::sin(v)});
        }
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
            const std::uint32_t a = i * n + j, b = (i + 1) % n * n + j, c = (i + 1) % n * n + (j + 1) % n, d = i * n + (j + 1) % n;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
    return mesh;
}

void BM_CheckMesh(benchmark::State& state) {
    const solid::Mesh mesh = waved_torus(static_cast<std::uint32_t>(state.range(0)));
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
// 20,000, 51,000, 100,000, 500,000, 1,000,000 and 2,000,000 triangles
BENCHMARK(BM_CheckMesh)
    ->ArgNames({"n", "process"})
    ->Args({100, kFdm})
    ->Args({160, kFdm})
    ->Args({160, kMill4})
    ->Args({224, kFdm})
    ->Args({500, kFdm})
    ->Args({707, kFdm})
    ->Args({1000, kFdm})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
