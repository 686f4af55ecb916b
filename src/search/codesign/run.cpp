#include "evolution.h"
#include "fusee/core/file.h"
#include "fusee/search/design.h"

namespace fs = std::filesystem;

namespace fusee::search::codesign {

fs::path result_folder(const profile::Profile& profile, const RunOptions& options) { return options.out / (profile.name + "-design"); }

fs::path checkpoint_file(const profile::Profile& profile, const RunOptions& options) {
    return options.out / (profile.name + "-design.checkpoint");
}

core::OutputRun output_run(const profile::Profile& profile, const RunOptions& options) {
    return {.command = "design", .source = profile.file, .force = options.force, .stays = true};
}

profile::Profile moved(profile::Profile profile, const fs::path& folder) {
    const fs::path from = profile.file.parent_path(), to = fs::absolute(folder).lexically_normal();
    const auto move = [&](fs::path& file) {
        if (!file.empty() && file.is_relative()) file = fs::absolute(from / file).lexically_normal().lexically_relative(to);
    };
    move(profile.rig.gear_friction_table.file);
    move(profile.simulate.measured.file);
    move(profile.co_design.catalogue_file);
    if (auto* one = std::get_if<profile::OneSpring>(&profile.law.curves)) move(one->rows.file);
    if (auto* table = std::get_if<profile::TablePair>(&profile.law.curves)) move(table->file);
    if (auto* wanted = std::get_if<profile::DeadBandSpec>(&profile.law.curves)) {
        move(wanted->dead_band.rows.file);
        move(wanted->series_stiffness.rows.file);
    }
    return profile;
}

design::EvolutionOptions evolution_of(const profile::Profile& profile, std::vector<core::Range> bounds, const RunOptions& run) {
    design::EvolutionOptions options;
    options.bounds = std::move(bounds);
    options.population = profile.search.population;
    options.generations = profile.search.generations;
    options.seed = static_cast<std::uint64_t>(profile.search.seed);
    options.jobs = run.jobs;
    options.stop = run.stop;
    return options;
}

void keep_checkpoint(design::EvolutionOptions& options, const profile::Profile& profile, const RunOptions& run, std::string problem) {
    if (!run.out.empty()) {
        core::make_folder(run.out);
        options.checkpoint = checkpoint_file(profile, run);
    }
    options.resume = run.resume;
    options.force = run.force;
    options.problem = std::move(problem);
    options.progress = run.progress;
}

}  // namespace fusee::search::codesign
