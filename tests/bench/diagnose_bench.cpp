// Where the time of `fusee diagnose` goes, on full cases of the plant: a faultless rig, one effect that explains all, one that leaves a
// little (so that pairs are sought), two effects.
//   cmake -S . -B build-bench -G Ninja -DFUSEE_BUILD_BENCH=ON && cmake --build build-bench --target run_bench_diagnose
// Counters are shares of the diagnosis, in per cent; `peak_MB` is the largest resident size of this process up to the end of the benchmark.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <chrono>
#include <filesystem>
#include <map>

#include "fusee/core/file.h"
#include "fusee/diagnosis/diagnose.h"
#include "fusee/joint_model/signals.h"
#include "fusee/plant/case_files.h"

namespace fs = std::filesystem;
using namespace fusee;

namespace {

gap_case::Case plant_case(const std::vector<plant::Effect>& effects) {
    const fs::path folder = fs::temp_directory_path() / "fusee_bench_case";
    fs::remove_all(folder);
    for (const auto& [name, bytes] : plant::make_case(7, 3, effects)) {
        fs::create_directories((folder / name).parent_path());
        core::write_file(folder / name, bytes);
    }
    return gap_case::read_case(folder);
}

const plant::Effect kRadius{"pe.radius", "agonist", 1e-3, {}}, kStribeck{"gear.stribeck", "agonist", 0.8, {{"speed_rad_per_s", 0.1}}},
    kCoulomb{"gear.coulomb", "both", 0.05, {}};

void BM_Predict(benchmark::State& state) {
    const gap_case::Case bench = plant_case({});
    const auto experiment = static_cast<gap_case::Experiment>(state.range(0));
    joint_model::BuiltRig rig(bench.rig);
    rig.assemble(joint_model::NominalCams(bench.rig));
    for (auto _ : state) benchmark::DoNotOptimize(joint_model::predict_experiment(rig, bench.rows, bench.protocol, experiment));
    state.SetLabel(to_string(experiment));
}
BENCHMARK(BM_Predict)->DenseRange(0, static_cast<int>(gap_case::kExperiments) - 1)->Unit(benchmark::kMicrosecond);

void diagnose(benchmark::State& state, const std::vector<plant::Effect>& effects) {
    const gap_case::Case bench = plant_case(effects);
    std::map<std::string, double> seconds;
    double all = 0.0;
    for (auto _ : state) {
        auto last = std::chrono::steady_clock::now();
        diagnosis::DiagnoseOptions options;
        options.jobs = static_cast<unsigned>(state.range(0));
        options.progress = [&](std::size_t, std::size_t, const std::string& what) {
            const auto now = std::chrono::steady_clock::now();
            const double part = std::chrono::duration<double>(now - last).count();
            seconds[what] += part;
            all += part;
            last = now;
        };
        benchmark::DoNotOptimize(diagnosis::diagnose(bench, options));
    }
    for (const auto& [what, part] : seconds) state.counters[what] = 100.0 * part / all;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["peak_MB"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void BM_DiagnoseFaultless(benchmark::State& state) { diagnose(state, {}); }
void BM_DiagnoseOne(benchmark::State& state) { diagnose(state, {kRadius}); }
void BM_DiagnoseStribeck(benchmark::State& state) { diagnose(state, {kStribeck}); }
void BM_DiagnoseTwo(benchmark::State& state) { diagnose(state, {kRadius, kCoulomb}); }
BENCHMARK(BM_DiagnoseFaultless)->ArgName("jobs")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(BM_DiagnoseOne)->ArgName("jobs")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(BM_DiagnoseStribeck)->ArgName("jobs")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(BM_DiagnoseTwo)->ArgName("jobs")->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

}  // namespace
