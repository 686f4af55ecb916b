#include "fusee/batch/batch.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <set>
#include <thread>

#include "fusee/core/error.h"
#include "fusee/core/progress.h"

namespace fs = std::filesystem;

namespace fusee::batch {

namespace {

/// Runs `work` and turns what it throws into a row's outcome and error.
template <class Work>
void guarded(Row& row, const Work& work) {
    try {
        work();
    } catch (const core::InvalidInput& e) {
        row.outcome = Outcome::kBadInput, row.error = e.what();
    } catch (const core::IoError& e) {
        row.outcome = Outcome::kBadInput, row.error = e.what();
    } catch (const std::exception& e) {
        row.outcome = Outcome::kFailed, row.error = e.what();
    }
}

struct Job {
    Row row;
    std::optional<profile::Profile> profile;
};

/// All profiles are read before the first is made: what is wrong with a file is known at once, and names are compared.
std::vector<Job> read_all(const std::vector<fs::path>& paths) {
    std::vector<Job> jobs;
    std::set<std::string> names;
    for (const fs::path& path : paths) {
        Job& job = jobs.emplace_back();
        job.row.profile = path;
        guarded(job.row, [&] {
            profile::Profile read = profile::read_profile(path);
            job.row.result.name = read.name;
            if (!names.insert(read.name).second)
                throw core::InvalidInput(read.place_of("name"), read.name,
                                         "a name that no other profile of this run has: each design gets out/NAME");
            job.profile = std::move(read);
        });
    }
    return jobs;
}

void run(Job& job, const pipeline::MakeOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    guarded(job.row, [&] {
        try {
            job.row.result = pipeline::make(*job.profile, options);
        } catch (const core::InvalidInput& e) {  // a room below knows the key, the profile its line
            throw core::InvalidInput(job.profile->place_of(e.field()), e.value(), e.allowed());
        }
        job.row.outcome = job.row.result.made ? Outcome::kMade : Outcome::kRefused;
    });
    job.row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
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
    std::vector<Job> work = read_all(profiles);
    std::unique_ptr<core::Progress> progress;
    if (work.size() > 1 || options.via == pipeline::Via::kOpenScad) progress = std::make_unique<core::Progress>("make", work.size());
    pipeline::MakeOptions watched = options;
    if (progress) watched.note = [&](const std::string& what) { progress->note(what); };
    std::atomic<std::size_t> next{0};
    const auto worker = [&] {
        for (std::size_t i = next++; i < work.size() && !core::interrupted(); i = next++) {
            if (work[i].profile) run(work[i], watched);
            if (progress) progress->advance(work[i].row.profile.filename().string() + ": " + to_string(work[i].row.outcome));
        }
    };
    const std::size_t wanted = jobs > 0 ? jobs : std::max(1u, std::thread::hardware_concurrency());
    const std::size_t workers = std::min(wanted, work.size());
    std::vector<std::jthread> pool;
    pool.reserve(workers);
    for (std::size_t i = 1; i < workers; ++i) pool.emplace_back(worker);  // this thread is one of them
    worker();
    pool.clear();  // joins
    std::vector<Row> rows;
    rows.reserve(work.size());
    for (Job& job : work) rows.push_back(std::move(job.row));
    return rows;
}

}  // namespace fusee::batch
