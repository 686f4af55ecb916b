#pragma once
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fusee/study/study.h"

/// A study on a cluster with Slurm (docs/cluster.md).
namespace fusee::batch {

/// The most tasks of a job array: Slurm's default MaxArraySize is 1001.
inline constexpr std::size_t kMostTasks = 1000;

struct SlurmOptions {
    std::vector<std::filesystem::path> paths;  ///< of the study, as on the command line
    std::string name;                          ///< of a list of profiles
    std::filesystem::path out = "out";
    std::size_t tasks = 0;  ///< of the job array; 0: about an hour for each
    std::string sbatch;     ///< further options of sbatch, e.g. "--partition=long --cpus-per-task=8"
    bool force = false;
    std::chrono::seconds patience{60};                         ///< with sbatch: it waits for a controller that does not answer
    std::function<void(const struct SlurmJobs&)> submitted{};  ///< called when the array is submitted; may be empty
    std::function<void(const std::string&)> stopped{};         ///< called with what to do if Ctrl-C comes between the jobs; may be empty
};

/// The scripts of the two jobs, in out/NAME/slurm, and their numbers.
struct SlurmJobs {
    std::filesystem::path array_script, merge_script;
    std::size_t tasks = 0;
    std::string array_job, merge_job;  ///< numbers
};

/// Writes the scripts and submits them: an array of one task for each shard, and a job that writes the index when all tasks have ended.
/// The numbers of the jobs are kept in out/NAME/slurm/jobs.txt, each as soon as it is known.
/// @throws core::IoError, also if sbatch is not there, refuses or does not answer: with the array's number if that one is submitted;
/// core::InvalidInput for a path that a script for Slurm cannot name; core::Stopped
[[nodiscard]] SlurmJobs submit_slurm(const study::Plan& plan, const SlurmOptions& options);

}  // namespace fusee::batch
