#include <algorithm>
#include <memory>

#include "fusee/batch/batch.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/mjcf/write.h"
#include "fusee/pipeline/rig.h"
#include "fusee/report/simulation.h"
#include "run_each.h"

namespace fusee::batch {

namespace {

/// Next to the folders of the joints; other files there stay.
void write_relatives(const std::vector<pipeline::Simulation>& done, const fs::path& out, bool force) {
    core::OutputFolder output(out, {.command = "simulate", .source = out, .force = force, .stays = true, .among_others = true});
    core::write_file(output.path() / "relatives.csv", report::relatives_csv(done));
    output.commit();
}

/// A folder of the joint's model for MuJoCo, checked before the work.
core::OutputFolder mjcf_folder(const fs::path& folder, const profile::Profile& profile, bool force) {
    return {folder,
            profile.name,
            {.command = "simulate",
             .source = profile.file,
             .force = force,
             .files = {mjcf::kModelFile, mjcf::kLawsFile, mjcf::kJavaScriptFile, mjcf::kPythonFile},
             .stays = true}};
}

/// One profile of `simulate_all`. @return true if it is simulated
bool simulate_into(SimulationRow& row, const profile::Profile& profile, const fs::path& out, const pipeline::SimulateOptions& options,
                   bool force, const fs::path& mjcf) {
    core::OutputFolder output(out, profile.name,
                              {.command = "simulate",
                               .source = profile.file,
                               .force = force,
                               .files = {"simulation.json", "simulation.html", "dead_band.csv"},
                               .stays = true});
    std::optional<core::OutputFolder> model;
    if (!mjcf.empty()) model.emplace(mjcf_folder(mjcf, profile, force));
    pipeline::require_joint(profile, "a simulation");
    const auto design = pipeline::resolve(profile);
    if (!design) {
        row.refusal = design.refusal();
        return false;
    }
    if (model) {
        const mjcf::Twin twin = pipeline::twin_of(*design);  // refuses other arrangements before a folder is made
        mjcf::write(twin, model->path());
    }
    pipeline::Simulation simulation = pipeline::simulate(*design, options);
    (void)report::write_simulation(simulation, output.path());
    output.commit();
    row.folder = output.target();
    if (model) {
        model->commit();
        row.mjcf = model->target();
    }
    row.refusal = pipeline::refusals(simulation);
    row.simulation = std::move(simulation);
    return row.refusal.empty();
}

/// A progress bar for several profiles.
std::unique_ptr<core::Progress> bar(const char* title, std::size_t count) {
    return count > 1 ? std::make_unique<core::Progress>(title, count) : nullptr;
}

}  // namespace

std::vector<SimulationRow> simulate_all(const std::vector<fs::path>& profiles, const fs::path& out,
                                        const pipeline::SimulateOptions& options, unsigned jobs, bool force, const fs::path& mjcf) {
    const auto progress = bar("simulate", profiles.size());
    std::vector<SimulationRow> rows(profiles.size());
    const auto work = [&](const profile::Profile& profile, std::size_t place) {
        return simulate_into(rows[place], profile, out, options, force, mjcf);
    };
    const std::vector<Ended> ended = run_each(profiles, work, jobs, progress.get());
    std::vector<pipeline::Simulation> done;
    for (const SimulationRow& row : rows)
        if (row.simulation) done.push_back(*row.simulation);
    const auto relative = [](const pipeline::Simulation& s) { return s.survey.arrangement != actuator::Arrangement::kPnrvsa; };
    if (std::any_of(done.begin(), done.end(), relative)) write_relatives(done, out, force);
    return joined(std::move(rows), ended);
}

}  // namespace fusee::batch
