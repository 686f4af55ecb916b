#include "fusee/batch/slurm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/batch/study.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/lists.h"
#include "fusee/core/process.h"
#include "fusee/core/progress.h"
#include "fusee/core/text.h"
#include "study_folder.h"

namespace fusee::batch {

namespace {

const std::string kFolder = "slurm", kArray = "array.sh", kMerge = "index.sh";
constexpr const char* kDigits = "0123456789";

/// "/usr/bin/fusee batch '/home/me/s.toml' --out '/home/me/out' --name 'batch'": absolute, since a task begins in another folder.
std::string command(const SlurmOptions& options) {
    std::string line = core::shell_word(fs::read_symlink("/proc/self/exe").string()) + " batch";
    for (const fs::path& path : options.paths) line += " " + core::shell_word(fs::absolute(path).string());
    return line + " --out " + core::shell_word(fs::absolute(options.out).string()) + " --name " + core::shell_word(options.name) +
           (options.force ? " --force" : "");
}

/// A text as sbatch reads it in a line of #SBATCH. @throws core::InvalidInput for what it cannot read there
std::string sbatch_word(const std::string& text) {
    std::string word = "\"";
    for (const char c : text) {
        if (c == '\\' || static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            throw core::InvalidInput("--out", core::printable(text),
                                     "a path without line ends, control characters and backslashes for Slurm");
        if (c == '"') word += '\\';
        word += c;
    }
    return word + '"';
}

/// Slurm replaces %a and the like in the name of a log.
std::string sbatch_folder(const fs::path& folder) {
    std::string text;
    for (const char c : folder.string()) text += c == '%' ? "%%" : std::string(1, c);
    return text;
}

/// --requeue: a task whose node is lost runs again and goes on with what is missing.
std::string array_script(const SlurmOptions& options, const fs::path& folder, std::size_t tasks) {
    return fmt::format(
        "#!/bin/sh\n#SBATCH --job-name={0}\n#SBATCH --array=1-{1}\n#SBATCH --requeue\n#SBATCH --output={2}\n#SBATCH "
        "--open-mode=append\n"
        "exec {3} --shard \"$SLURM_ARRAY_TASK_ID/{1}\" --jobs \"${{SLURM_CPUS_PER_TASK:-1}}\"\n",
        folder.parent_path().filename().string(), tasks, sbatch_word(sbatch_folder(folder) + "/%a.log"), command(options));
}

std::string merge_script(const SlurmOptions& options, const fs::path& folder) {
    return fmt::format("#!/bin/sh\n#SBATCH --job-name={0}-index\n#SBATCH --requeue\n#SBATCH --output={1}\nexec {2} --merge\n",
                       folder.parent_path().filename().string(), sbatch_word(sbatch_folder(folder) + "/index.log"), command(options));
}

/// The last line of a program's output that is the number of a job, "123" or "123;cluster": warnings may stand before it.
std::string number_in(const std::string& output) {
    std::string number;
    for (const std::string& line : core::pieces_of<std::string>(output, "\n"))
        if (const std::string first = line.substr(0, line.find(';'));
            !first.empty() && first.find_first_not_of(kDigits) == std::string::npos)
            number = first;
    return number;
}

/// @returns the number of the new job @throws core::IoError
std::string submit(const std::vector<std::string>& options, const fs::path& script, std::chrono::seconds patience) {
    constexpr const char* kLook = "it may have submitted the job all the same: look with squeue --me before you submit again";
    std::vector<std::string> words{"sbatch", "--parsable"};
    words.insert(words.end(), options.begin(), options.end());
    words.push_back(script.string());
    const core::ProcessResult done = core::run_process(words, script.string(), patience);
    if (!done.in_time)
        throw core::IoError(script.string(), fmt::format("sbatch gave no answer in {} s and was ended; {}", patience.count(), kLook));
    if (done.code != 0) throw core::IoError(script.string(), "sbatch refuses it: " + core::printable(core::last_words(done.output)));
    std::string number = number_in(done.output);
    if (number.empty())
        throw core::IoError(script.string(), fmt::format("sbatch answered \"{}\", not the number of a job; {}",
                                                         core::printable(core::last_words(done.output)), kLook));
    return number;
}

/// Tasks of about an hour for one processor.
std::size_t usual_tasks(const study::Plan& plan) {
    const double hours = static_cast<double>(plan.size()) * usual_cost(plan.study().outputs).seconds / 3600.0;
    return std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(hours)), 1, std::clamp<std::size_t>(plan.size(), 1, kMostTasks));
}

/// Scripts, and the numbers of the jobs that are submitted.
void write_folder(const study::Plan& plan, const SlurmOptions& options, const SlurmJobs& jobs) {
    const std::string jobs_name = kFolder + "/jobs.txt";
    core::OutputFolder output =
        study_folder(plan, options.out, options.force, "batch --slurm", {kFolder + '/' + kArray, kFolder + '/' + kMerge, jobs_name});
    const fs::path folder = jobs.array_script.parent_path();
    core::make_folder(output.path() / kFolder);
    core::write_file(output.path() / kFolder / kArray, array_script(options, folder, jobs.tasks));
    core::write_file(output.path() / kFolder / kMerge, merge_script(options, folder));
    std::string numbers;
    if (!jobs.array_job.empty()) numbers += fmt::format("{} {}\n", kArray, jobs.array_job);
    if (!jobs.merge_job.empty()) numbers += fmt::format("{} {}\n", kMerge, jobs.merge_job);
    if (!numbers.empty()) core::write_file(output.path() / jobs_name, numbers);
    output.commit();
}

}  // namespace

SlurmJobs submit_slurm(const study::Plan& plan, const SlurmOptions& options) {
    const fs::path folder = fs::absolute(options.out / plan.study().name) / kFolder;
    (void)merge_script(options, folder);  // refuses a path before anything is written
    (void)claim_study_folder(plan, options.out, options.force);
    SlurmJobs jobs{folder / kArray, folder / kMerge, options.tasks > 0 ? options.tasks : usual_tasks(plan), {}, {}};
    write_folder(plan, options, jobs);
    if (!core::on_path("sbatch"))
        throw core::IoError(jobs.array_script.string(), "sbatch is not on PATH; submit this script where Slurm is, and after it " + kMerge);
    const std::vector<std::string> more = core::words_of(options.sbatch);
    jobs.array_job = submit(more, jobs.array_script, options.patience);
    write_folder(plan, options, jobs);  // kept before anything else can fail
    if (options.submitted) options.submitted(jobs);
    std::vector<std::string> after = more;
    after.push_back("--dependency=afterany:" + jobs.array_job);
    const std::string rest = fmt::format(
        "job {0} with {1} tasks is submitted, the job of the index is not. Submit it: sbatch --dependency=afterany:{0} {2}; or end the "
        "first: scancel {0}",
        jobs.array_job, jobs.tasks, core::shell_word(jobs.merge_script.string()));
    try {
        jobs.merge_job = submit(after, jobs.merge_script, options.patience);
    } catch (const core::IoError& e) {
        throw core::IoError(e.what(), rest);
    } catch (const core::Stopped&) {
        if (options.stopped) options.stopped(rest);
        throw;
    }
    write_folder(plan, options, jobs);
    return jobs;
}

}  // namespace fusee::batch
