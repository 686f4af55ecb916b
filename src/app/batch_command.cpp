#include <fmt/ranges.h>

#include <chrono>

#include "arguments.h"
#include "fusee/batch/slurm.h"
#include "fusee/batch/study.h"
#include "fusee/core/progress.h"
#include "fusee/core/text.h"
#include "fusee/profile/places.h"
#include "fusee/study/store.h"

namespace fusee::app {

namespace {

struct BatchArguments {
    std::vector<std::filesystem::path> paths;
    std::string name = "batch";
    std::string shard;
    bool dry_run = false, merge = false, slurm = false;
    batch::SlurmOptions cluster;
    batch::StudyOptions options;
};

/// One study, or profiles and folders of them.
study::Study study_of(const BatchArguments& arguments) {
    std::vector<std::filesystem::path> files = profile::find_profiles(arguments.paths);
    if (files.size() == 1 && study::is_study(files.front())) return study::read_study(files.front());
    for (const auto& file : files)
        if (std::filesystem::exists(file) && study::is_study(file))
            throw core::InvalidInput("batch", core::printable(file.string()), "one study, or profiles; not both");
    return study::study_of(std::move(files), arguments.name);
}

int list_designs(const study::Plan& plan, Reply& reply) {
    std::size_t excluded = 0;
    Json designs = Json::array();
    for (std::size_t i = 0; i < plan.size() && reply.is_heard(); ++i) {
        if (core::interrupted()) throw core::Stopped();
        const study::Planned planned = plan.at(i);
        std::string values;
        Json keys = Json::object();
        for (std::size_t key = 0; key < planned.values.size(); ++key) {
            values += fmt::format("  {} = {}", plan.study().vary[key].key, planned.values[key]);
            keys[plan.study().vary[key].key] = planned.values[key];
        }
        if (!planned.excluded_by.empty()) ++excluded, values += "  left out: " + planned.excluded_by;
        if (reply.json()) designs.push_back({{"name", planned.name}, {"values", keys}, {"left_out_by", planned.excluded_by}});
        reply.print(fmt::format("{}{}\n", planned.name, values));
    }
    const double bytes = static_cast<double>(plan.size() - excluded) * batch::usual_cost(plan.study().outputs).bytes;
    reply.result = {{"step", "dry run"}, {"designs", designs}, {"bytes", bytes}};
    reply.print(fmt::format("{} designs, {} left out by constraints; about {} on disk\n", plan.size() - excluded, excluded,
                            core::bytes_text(bytes)));
    return 0;
}

Json result_json(const batch::StudyResult& result) {
    return {{"step", "make"},
            {"folder", result.folder.string()},
            {"planned", result.planned},
            {"made", result.made},
            {"refused", result.refused},
            {"earlier", result.earlier},
            {"left_out", result.excluded},
            {"bad_input", result.bad_input},
            {"failed", result.failed},
            {"indexed", result.indexed},
            {"reasons", result.reasons}};
}

/// Says which lines of the logs are not taken.
void print(const study::BadRows& bad, Reply& reply) {
    if (bad.count == 0) return;
    reply.result["bad_rows"] = bad.count;
    reply.warn(fmt::format("rows not taken: {}. A design without another row is made again:\n", bad.count));
    for (const std::string& why : bad.first) reply.warn(fmt::format("    {}\n", core::printable(why)));
    if (bad.count > bad.first.size()) reply.warn(fmt::format("    and {} more\n", bad.count - bad.first.size()));
}

void print(const batch::StudyResult& result, Reply& reply) {
    reply.result = result_json(result);
    std::string text = fmt::format("{}/  {} design{}: {} made, {} refused, {} finished earlier, {} left out by constraints",
                                   core::printable(result.folder.string()), result.planned, result.planned == 1 ? "" : "s", result.made,
                                   result.refused, result.earlier, result.excluded);
    if (result.bad_input + result.failed > 0)
        text += fmt::format(", {} with bad input, {} with an internal error", result.bad_input, result.failed);
    print(result.bad_rows, reply);
    reply.say(text + "\n");
    for (const std::string& reason : result.reasons) {
        reply.fail(reason);
        reply.warn(fmt::format("    {}\n", reason));
    }
    if (result.bad_input + result.failed > result.reasons.size())
        reply.warn(fmt::format("    and {} more\n", result.bad_input + result.failed - result.reasons.size()));
    if (result.interrupted) reply.warn("stopped: the same command goes on with the designs that are missing\n");
    if (!result.interrupted && result.indexed > 0)
        reply.say(fmt::format(
            "index: {0}/index.html, index.csv, index.sqlite; fusee query {0} \"SELECT name, mass_g FROM designs ORDER BY mass_g LIMIT "
            "5\"\n",
            core::printable(result.folder.string())));
}

int submit(const study::Plan& plan, BatchArguments& arguments, Reply& reply) {
    batch::SlurmOptions& options = arguments.cluster;
    options.paths = arguments.paths, options.name = arguments.name;
    options.out = arguments.options.out, options.force = arguments.options.force;
    options.submitted = [&reply](const batch::SlurmJobs& jobs) {
        reply.say(
            fmt::format("submitted: job {} with {} tasks ({})\n", jobs.array_job, jobs.tasks, core::printable(jobs.array_script.string())));
    };
    options.stopped = [&reply](const std::string& rest) { reply.warn(core::printable(rest) + "\n"); };
    const batch::SlurmJobs jobs = batch::submit_slurm(plan, options);
    reply.result = {{"step", "slurm"}, {"array_job", jobs.array_job}, {"tasks", jobs.tasks}, {"merge_job", jobs.merge_job}};
    reply.say(fmt::format("submitted: job {} for the index ({})\n", jobs.merge_job, core::printable(jobs.merge_script.string())));
    return 0;
}

/// "3 of 8 (25 designs), 5 of 8 (1 design)"
std::string shards_text(const batch::IndexSize& index) {
    std::string text;
    for (const auto& [number, designs] : index.missing_of_shard)
        text += fmt::format("{}--shard {}/{} ({})", text.empty() ? "" : ", ", number, index.shards, designs);
    return text;
}

int merge(const study::Plan& plan, const batch::StudyOptions& options, Reply& reply) {
    const batch::IndexSize index = batch::write_index(plan, options.out, options.force);
    print(index.bad_rows, reply);
    if (index.designs == 0)
        throw core::InvalidInput("--merge", core::printable((options.out / plan.study().name).string()), "a study with finished designs");
    reply.result.update({{"step", "merge"}, {"indexed", index.designs}, {"missing", index.missing}});
    reply.say(fmt::format("index of {} designs; {} are missing\n", index.designs, index.missing));
    if (index.missing == 0) return 0;
    std::string text = fmt::format("{} designs have no row, and the index lacks them: {}", index.missing, fmt::join(index.names, ", "));
    if (index.missing > index.names.size()) text += fmt::format(" and {} more", index.missing - index.names.size());
    if (index.shards > 0) text += ". Designs to make, by shard: " + shards_text(index);
    reply.fail(text);
    reply.warn(text + ". The same command without --merge makes them\n");
    return kBadInput;
}

int run_batch(BatchArguments arguments, Reply& reply) {
    require_thread();
    if (!arguments.shard.empty()) arguments.options.shard = batch::parse_shard(arguments.shard);
    const study::Plan plan(study_of(arguments));
    if (arguments.dry_run) return list_designs(plan, reply);
    if (arguments.slurm) return submit(plan, arguments, reply);
    if (arguments.merge) return merge(plan, arguments.options, reply);
    const batch::StudyResult result = batch::run_study(plan, arguments.options);
    print(result, reply);
    return batch::exit_code(result);
}

struct QueryArguments {
    std::filesystem::path study;
    std::string sql;
    unsigned seconds = 60;
};

constexpr std::size_t kMostRowsOfJson = 1'000'000;  // they stand in memory

int run_query(const QueryArguments& arguments, Reply& reply) {
    const auto file = std::filesystem::is_directory(arguments.study) ? arguments.study / "index.sqlite" : arguments.study;
    bool head = true;
    reply.result = {{"columns", Json::array()}, {"rows", Json::array()}};
    study::query(file, arguments.sql, std::chrono::seconds(arguments.seconds), [&](const std::vector<std::string>& cells) {
        std::string line;
        for (std::size_t i = 0; i < cells.size(); ++i) line += (i > 0 ? "\t" : "") + core::printable(cells[i]);
        reply.print(line + "\n");
        if (head)
            reply.result["columns"] = cells;
        else if (reply.json())
            reply.result["rows"].push_back(cells);
        if (reply.json() && reply.result["rows"].size() > kMostRowsOfJson)
            throw core::InvalidInput(
                "SQL", fmt::format("the answer has more than {0} rows: add LIMIT {0}, or leave out --json", kMostRowsOfJson), "");
        head = false;
        return reply.is_heard();
    });
    return 0;
}

}  // namespace

void add_batch(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "batch", run_batch);
    command->add_option("study", arguments->paths, "A study (*.toml with a table [study]), or profiles and folders of them")
        ->type_name("FILE.toml")
        ->check(reads({FileKind::kStudy, FileKind::kProfile}, "a study, or profiles"))
        ->required();
    add_out(*command, arguments->options.out, "Folder that gets the folder of the study");
    command->add_option("--name", arguments->name, "Name of the folder for a list of profiles")->capture_default_str();
    CLI::Option* dry_run = command->add_flag("--dry-run", arguments->dry_run, "List the designs and the size on disk; make nothing");
    CLI::Option* shard =
        command->add_option("--shard", arguments->shard, "NUMBER/COUNT: make only this share of the designs, without the index")
            ->excludes(dry_run);
    CLI::Option* merge = command->add_flag("--merge", arguments->merge, "Make no design; write the index of those that are finished")
                             ->excludes(dry_run)
                             ->excludes(shard);
    CLI::Option* slurm =
        command->add_flag("--slurm", arguments->slurm, "Submit the study to Slurm: a job array, and a job that writes the index")
            ->excludes(dry_run)
            ->excludes(shard)
            ->excludes(merge);
    command->add_option("--slurm-tasks", arguments->cluster.tasks, "Tasks of the array; 0 = about an hour for each")
        ->check(number_within(std::size_t{0}, batch::kMostTasks))
        ->capture_default_str()
        ->needs(slurm);
    command
        ->add_option("--slurm-options", arguments->cluster.sbatch, "Further options of sbatch, e.g. \"--partition=long --cpus-per-task=8\"")
        ->needs(slurm);
    add_force(*command, arguments->options.force);
    add_jobs(*command, arguments->options.jobs, "Designs made at the same time; 0 = one for each processor");
    command->footer(
        "Example:\n  fusee batch profiles/studies/pnrvsa.toml\n  fusee batch profiles --dry-run\n\n"
        "Exit code: 0 every design is made or refused, 2 bad input of the study or of a design, or a merge that lacks designs, 3 internal "
        "error, 130 stopped by Ctrl-C.\n"
        "The same command again makes only the designs that are missing.");
}

void add_query(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "query", run_query);
    command->add_option("study", arguments->study, "Folder of a study, out/NAME")
        ->type_name("FOLDER")
        ->check(reads({FileKind::kStudyFolder}, "the folder that fusee batch wrote, out/NAME"))
        ->required();
    command->add_option("sql", arguments->sql, "A SELECT on the tables designs and columns")->required();
    add_number(*command, "--seconds", arguments->seconds, 1U, 86'400U, "Longest time of the query [s]");
    command->footer(
        "Example:\n  fusee query out/pnrvsa \"SELECT name, mass_g FROM designs ORDER BY mass_g LIMIT 5\"\n\n"
        "Exit code: 0, or 2 for bad input.");
}

}  // namespace fusee::app
