#include "fusee/batch/batch.h"

#include <algorithm>
#include <memory>

#include "fusee/core/file.h"
#include "fusee/core/output_folder.h"
#include "fusee/core/units.h"
#include "fusee/report/report.h"
#include "fusee/report/simulation.h"
#include "run_each.h"

namespace fs = std::filesystem;

namespace fusee::batch {

namespace {

/// The rows with the outcome of each.
template <class AnyRow>
std::vector<AnyRow> joined(std::vector<AnyRow> rows, const std::vector<Ended>& ended) {
    for (std::size_t i = 0; i < rows.size(); ++i) static_cast<Ended&>(rows[i]) = ended[i];
    return rows;
}

/// Next to the folders of the joints; other files there stay.
void write_relatives(const std::vector<pipeline::Simulation>& done, const fs::path& out, bool force) {
    core::OutputFolder output(out, {.command = "simulate", .source = out, .force = force, .among_others = true});
    core::write_file(output.path() / "relatives.csv", report::relatives_csv(done));
    output.commit();
}

/// A progress bar for several profiles or long work.
std::unique_ptr<core::Progress> bar(const char* title, std::size_t count, bool long_work) {
    return count > 1 || long_work ? std::make_unique<core::Progress>(title, count) : nullptr;
}

}  // namespace

MakeResult make(const profile::Profile& profile, const MakeOptions& options) {
    pipeline::require_parts(profile);
    core::OutputFolder output(options.out / profile.name, {.command = "make",
                                                           .source = profile.file,
                                                           .force = options.force,
                                                           .files = {"report.json", "report.html", "springs.csv", "simulation.json",
                                                                     "simulation.html", "dead_band.csv"},
                                                           .sheets = pipeline::sheets_of(profile)});
    MakeResult result;
    result.name = profile.name;
    const auto made = pipeline::make_parts(profile, output, {.via = options.via, .note = options.note});
    result.findings = made ? made->report.all_findings() : made.refusal();
    if (!made) return result;
    result.headline = made->report.headline;
    result.file_errors = made->report.file_errors();
    if (core::any_error(result.findings)) return result;  // a file does not carry the law: the files go
    report::write_design(*made, output.path());
    output.commit();
    result.made = true;
    result.folder = output.target();
    const actuator::Actuator& joint = made->resolved.actuator;
    result.dead_band_peak_deg = core::deg_from_rad(actuator::dead_band(joint, joint.peak_torque).exact_width);
    return result;
}

std::vector<Row> make_all(const std::vector<fs::path>& profiles, const MakeOptions& options, unsigned jobs) {
    const auto progress = bar("make", profiles.size(), options.via == pipeline::Via::kOpenScad);
    MakeOptions watched = options;
    if (progress) watched.note = [&](const std::string& what) { progress->note(what); };
    std::vector<Row> rows(profiles.size());
    const auto work = [&](const profile::Profile& profile, std::size_t place) {
        rows[place].result = make(profile, watched);
        return rows[place].result.made;
    };
    const std::vector<Ended> ended = run_each(profiles, work, jobs, progress.get());
    return joined(std::move(rows), ended);
}

std::vector<SimulationRow> simulate_all(const std::vector<fs::path>& profiles, const fs::path& out,
                                        const pipeline::SimulateOptions& options, unsigned jobs, bool force) {
    const auto progress = bar("simulate", profiles.size(), false);
    std::vector<SimulationRow> rows(profiles.size());
    const auto work = [&](const profile::Profile& profile, std::size_t place) {
        SimulationRow& row = rows[place];
        core::OutputFolder output(out / profile.name, {.command = "simulate",
                                                       .source = profile.file,
                                                       .force = force,
                                                       .files = {"simulation.json", "simulation.html", "dead_band.csv"}});
        auto simulation = pipeline::simulate(profile, options);
        if (!simulation) {
            row.refusal = simulation.refusal();
            return false;
        }
        (void)report::write_simulation(*simulation, output.path());
        output.commit();
        row.folder = output.target();
        row.simulation = std::move(simulation).value();
        row.refusal = pipeline::refusals(*row.simulation);
        return row.refusal.empty();
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
