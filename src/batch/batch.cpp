#include "fusee/batch/batch.h"

#include <algorithm>
#include <memory>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/output_folder.h"
#include "run_each.h"

namespace fs = std::filesystem;

namespace fusee::batch {

namespace {

/// The rows' own results under how each ended.
template <class AnyRow>
std::vector<AnyRow> joined(std::vector<AnyRow> rows, const std::vector<Ended>& ended) {
    for (std::size_t i = 0; i < rows.size(); ++i) static_cast<Ended&>(rows[i]) = ended[i];
    return rows;
}

/// Beside the folders of the joints, whatever else lies there.
void write_relatives(const std::vector<report::Simulation>& done, const fs::path& out, bool force) {
    core::OutputFolder output(out, {.command = "simulate", .source = out, .force = force, .among_others = true});
    core::write_file(output.path() / "relatives.csv", report::relatives_csv(done));
    output.commit();
}

/// A bar is worth its line when there is more than one to wait for.
std::unique_ptr<core::Progress> bar(const char* title, std::size_t count, bool long_work) {
    return count > 1 || long_work ? std::make_unique<core::Progress>(title, count) : nullptr;
}

}  // namespace

std::vector<fs::path> find_profiles(const std::vector<fs::path>& paths) {
    std::vector<fs::path> found;
    for (const fs::path& path : paths) {
        std::error_code error;
        if (!fs::is_directory(path, error)) {
            found.push_back(path);  // also what does not exist: that becomes its row
            continue;
        }
        error.clear();
        std::vector<fs::path> inside;
        for (auto entry = fs::directory_iterator(path, error); !error && entry != fs::directory_iterator(); entry.increment(error))
            if (entry->path().extension() == ".toml" && !fs::is_directory(entry->path())) inside.push_back(entry->path());
        if (error) throw core::IoError(path.string(), error.message());
        if (inside.empty()) throw core::IoError(path.string(), "holds no profile (*.toml)");
        std::sort(inside.begin(), inside.end());
        found.insert(found.end(), inside.begin(), inside.end());
    }
    return found;
}

std::vector<Row> make_all(const std::vector<fs::path>& profiles, const pipeline::MakeOptions& options, unsigned jobs) {
    const auto progress = bar("make", profiles.size(), options.via == pipeline::Via::kOpenScad);
    pipeline::MakeOptions watched = options;
    if (progress) watched.note = [&](const std::string& what) { progress->note(what); };
    std::vector<Row> rows(profiles.size());
    const auto work = [&](const profile::Profile& profile, std::size_t place) {
        rows[place].result = pipeline::make(profile, watched);
        return rows[place].result.made;
    };
    const std::vector<Ended> ended = run_each(profiles, work, jobs, progress.get());
    return joined(std::move(rows), ended);
}

std::vector<SimulationRow> simulate_all(const std::vector<fs::path>& profiles, const fs::path& out,
                                        const pipeline::SimulateOptions& options, unsigned jobs) {
    const auto progress = bar("simulate", profiles.size(), false);
    std::vector<SimulationRow> rows(profiles.size());
    const auto work = [&](const profile::Profile& profile, std::size_t place) {
        SimulationRow& row = rows[place];
        core::OutputFolder output(out / profile.name, {.command = "simulate",
                                                       .source = profile.file,
                                                       .force = options.force,
                                                       .files = {"simulation.json", "simulation.html", "dead_band.csv"}});
        auto simulation = pipeline::simulate(profile, options);
        if (!simulation) {
            row.refusal = simulation.refusal();
            return false;
        }
        (void)pipeline::write_simulation(*simulation, output.path());
        output.commit();
        row.folder = output.target();
        row.simulation = std::move(simulation).value();
        row.refusal = report::refusals(*row.simulation);
        return row.refusal.empty();
    };
    const std::vector<Ended> ended = run_each(profiles, work, jobs, progress.get());
    std::vector<report::Simulation> done;
    for (const SimulationRow& row : rows)
        if (row.simulation) done.push_back(*row.simulation);
    const auto relative = [](const report::Simulation& s) { return s.survey.arrangement != actuator::Arrangement::kPnrvsa; };
    if (std::any_of(done.begin(), done.end(), relative)) write_relatives(done, out, options.force);
    return joined(std::move(rows), ended);
}

}  // namespace fusee::batch
