#include "fusee/batch/slurm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "fusee/batch/study.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/process.h"
#include "fusee/core/text.h"
#include "study_folder.h"

namespace fs = std::filesystem;

namespace fusee::batch {

namespace {

constexpr std::chrono::seconds kSubmitTime{60};

/// "/usr/bin/fusee batch '/home/me/s.toml' --out '/home/me/out' --name 'batch'": absolute, since a task begins in another folder.
std::string command(const SlurmOptions& options) {
    std::string line = core::shell_word(fs::read_symlink("/proc/self/exe").string()) + " batch";
    for (const fs::path& path : options.paths) line += " " + core::shell_word(fs::absolute(path).string());
    return line + " --out " + core::shell_word(fs::absolute(options.out).string()) + " --name " + core::shell_word(options.name) +
           (options.force ? " --force" : "");
}

/// --requeue: a task whose node is lost runs again and goes on with what is missing.
std::string array_script(const SlurmOptions& options, const fs::path& folder, std::size_t tasks) {
    return fmt::format(
        "#!/bin/sh\n#SBATCH --job-name={0}\n#SBATCH --array=1-{1}\n#SBATCH --requeue\n#SBATCH --output={2}/%a.log\n#SBATCH "
        "--open-mode=append\n"
        "exec {3} --shard \"$SLURM_ARRAY_TASK_ID/{1}\" --jobs \"${{SLURM_CPUS_PER_TASK:-1}}\"\n",
        folder.parent_path().filename().string(), tasks, folder.string(), command(options));
}

std::string merge_script(const SlurmOptions& options, const fs::path& folder) {
    return fmt::format("#!/bin/sh\n#SBATCH --job-name={0}-index\n#SBATCH --requeue\n#SBATCH --output={1}/index.log\nexec {2} --merge\n",
                       folder.parent_path().filename().string(), folder.string(), command(options));
}

/// The number of the new job.
std::string submit(const std::vector<std::string>& options, const fs::path& script) {
    if (!core::on_path("sbatch")) throw core::IoError(script.string(), "sbatch is not on PATH; submit this script where Slurm is");
    std::vector<std::string> words{"sbatch", "--parsable"};
    words.insert(words.end(), options.begin(), options.end());
    words.push_back(script.string());
    const core::ProcessResult done = core::run_process(words, script.string(), kSubmitTime);
    if (done.code != 0) throw core::IoError(script.string(), "sbatch refuses it: " + core::last_words(done.output));
    return done.output.substr(0, done.output.find_first_of(";\n"));
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    return {std::istream_iterator<std::string>(in), {}};
}

/// Tasks of about an hour for one processor.
std::size_t usual_tasks(const study::Plan& plan) {
    const double hours = static_cast<double>(plan.size()) * usual_cost(plan.study().outputs).seconds / 3600.0;
    return std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(hours)), 1, std::clamp<std::size_t>(plan.size(), 1, kMostTasks));
}

}  // namespace

SlurmJobs submit_slurm(const study::Plan& plan, const SlurmOptions& options) {
    const fs::path folder = fs::absolute(claim_study_folder(plan, options.out, options.force)) / "slurm";
    fs::create_directories(folder);
    SlurmJobs jobs{folder / "array.sh", folder / "index.sh", options.tasks > 0 ? options.tasks : usual_tasks(plan), {}, {}};
    core::write_file(jobs.array_script, array_script(options, folder, jobs.tasks));
    core::write_file(jobs.merge_script, merge_script(options, folder));
    const std::vector<std::string> more = words_of(options.sbatch);
    jobs.array_job = submit(more, jobs.array_script);
    std::vector<std::string> after = more;
    after.push_back("--dependency=afterany:" + jobs.array_job);
    jobs.merge_job = submit(after, jobs.merge_script);
    return jobs;
}

}  // namespace fusee::batch
