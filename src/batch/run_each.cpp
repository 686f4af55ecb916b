#include "run_each.h"

#include <chrono>
#include <optional>
#include <set>

#include "fusee/core/parallel.h"

namespace fusee::batch {

namespace {

struct Job {
    Ended row;
    std::optional<profile::Profile> profile;
};

/// Reads all profiles before the work begins, so that errors of files are known at once and names can be compared.
std::vector<Job> read_all(const std::vector<fs::path>& paths) {
    std::vector<Job> jobs;
    std::set<std::string> names;
    for (const fs::path& path : paths) {
        Job& job = jobs.emplace_back();
        job.row.profile = path;
        guarded(job.row, [&] {
            profile::Profile read = profile::read_profile(path);
            if (!names.insert(read.name).second)
                throw core::InvalidInput(read.place_of("name"), read.name,
                                         "a name that no other profile of this run has: each design gets out/NAME");
            job.profile = std::move(read);
        });
    }
    return jobs;
}

void run(Job& job, const Work& work, std::size_t place) {
    const auto begin = std::chrono::steady_clock::now();
    guarded(job.row, [&] {
        try {
            job.row.outcome = work(*job.profile, place) ? Outcome::kMade : Outcome::kRefused;
        } catch (const core::InvalidInput& e) {  // a lower module knows the key, the profile its line
            throw core::InvalidInput(job.profile->place_of(e.field()), e.value(), e.allowed());
        }
    });
    job.row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

std::vector<Ended> run_each(const std::vector<fs::path>& profiles, const Work& work, unsigned jobs, core::Progress* progress) {
    std::vector<Job> all = read_all(profiles);
    core::parallel_for(all.size(), jobs, [&](std::size_t i) {
        if (core::interrupted()) return;
        if (all[i].profile) run(all[i], work, i);
        if (progress != nullptr) progress->advance(all[i].row.profile.filename().string() + ": " + to_string(all[i].row.outcome));
    });
    std::vector<Ended> rows;
    rows.reserve(all.size());
    for (Job& job : all) rows.push_back(std::move(job.row));
    return rows;
}

}  // namespace fusee::batch
