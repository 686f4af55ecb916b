#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "arguments.h"
#include "fusee/blind/score.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/core/progress.h"
#include "fusee/report/score.h"
#include "output.h"

namespace fusee::app {

namespace {

struct ScoreArguments {
    blind::ScoreOptions options;
    fs::path model, out;
};

/// The seal is printed before the first case is written.
int make_benchmark(blind::BenchmarkOptions options, Reply& reply) {
    require_thread();
    core::Progress progress("blind make", options.cases);
    options.progress = [&](std::size_t done, std::size_t, const std::string& what) {
        if (core::interrupted()) throw core::Stopped();
        if (done > 0) return progress.advance(what);
        reply.print(what + "\n");
        (void)flush_out();
    };
    const std::string seal = blind::make_benchmark(options);
    reply.result = {{"seal", "sha256:" + seal}, {"cases", options.cases}, {"folder", options.out.string()}};
    reply.say(fmt::format("written: {}\n", (options.out / "").string()));
    return 0;
}

blind::Score watched_score(blind::ScoreOptions options, const std::string& title) {
    std::optional<core::Progress> progress;
    options.progress = [&](std::size_t, std::size_t of, const std::string& what) {
        if (!progress) progress.emplace(title, of);
        progress->advance(what);
    };
    options.stop = core::interrupted;
    return blind::score(options);
}

int write_score(const ScoreArguments& arguments, Reply& reply) {
    core::OutputFolder output(arguments.out, {.command = "blind score",
                                              .source = arguments.options.folder,
                                              .force = arguments.options.force,
                                              .files = {"score.json", "score.html"}});
    const blind::Score score = watched_score(arguments.options, "blind score");
    std::optional<blind::Score> model;
    if (!arguments.model.empty()) {
        blind::ScoreOptions other = arguments.options;
        other.folder = arguments.model;
        other.hash.clear();
        model = watched_score(other, "model = plant");
    }
    const std::string json = blind::score_json(score, model);
    core::write_file(output.path() / "score.json", json);
    reply.set("score", json);
    core::write_file(output.path() / "score.html", report::score_html(score, model));
    output.commit();
    if (reply.json()) reply.result["folder"] = arguments.out.string();
    reply.say(fmt::format("{}written: {}/score.html, score.json\n", report::score_text(score, model), arguments.out.string()));
    return 0;
}

int score(const ScoreArguments& arguments, Reply& reply) {
    require_thread();
    try {
        return write_score(arguments, reply);
    } catch (const core::Stopped&) {
        reply.warn(fmt::format("stopped: the finished diagnoses stay in {} and are used next time\n",
                               (arguments.options.folder / "diagnoses").string()));
        return kInterrupted;
    }
}

void add_blind_make(CLI::App& blind, Action& action) {
    const auto options = std::make_shared<blind::BenchmarkOptions>();
    CLI::App* command = blind.add_subcommand("make", "Make gap cases of simulated rigs, and a sealed file with their faults");
    command->add_option("--seed", options->seed, "Seed; the same seed gives the same benchmark")
        ->required()
        ->check(number_within(std::uint64_t{0}, std::numeric_limits<std::uint64_t>::max()));
    command->add_option("--cases", options->cases, "Number of cases")->required()->check(number_within(1, 10000));
    add_out(*command, options->out, "Folder of the benchmark");
    add_force(*command, options->force);
    const auto maker = std::make_shared<std::string>("plant");
    command
        ->add_option("--plant", *maker,
                     "Source of the measurements: plant; mujoco or siconos, the same rig moved by this engine; or the model as a control")
        ->check(one_of(blind::maker_names()))
        ->capture_default_str();
    const auto family = std::make_shared<std::string>("usual");
    command
        ->add_option(
            "--family", *family,
            "usual: a mix of all kinds; form-blind: only effects that no law of the diagnosis describes; doubtful: three and four effects, "
            "wrong figures, unstated noise, two experiments, linear springs")
        ->check(one_of({"usual", "form-blind", "doubtful"}))
        ->capture_default_str();
    add_jobs(*command, options->jobs, "Number of threads; 0: one per processor. The result does not depend on it");
    command->footer(
        "Example:\n  fusee blind make --seed 1 --cases 500 --out blind\n\n"
        "Exit code: 0 the benchmark is made, 2 bad input, 3 internal error, 130 stopped by Ctrl-C: nothing is written.");
    command->callback([options, maker, family, &action] {
        if (*family == "doubtful") options->family = blind::Family::kDoubtful;
        if (*family == "form-blind") options->family = blind::Family::kFormBlind, options->mix = blind::kOutsideOnly;
        const std::vector<std::string>& names = blind::maker_names();
        options->maker = static_cast<blind::Maker>(std::find(names.begin(), names.end(), *maker) - names.begin());
        action = [options](Reply& reply) { return make_benchmark(*options, reply); };
    });
}

void add_blind_score(CLI::App& blind, Action& action) {
    const auto arguments = std::make_shared<ScoreArguments>();
    blind::ScoreOptions& options = arguments->options;
    CLI::App* command = blind.add_subcommand("score", "Diagnose every case, then open the seal and count the correct diagnoses");
    command->add_option("folder", options.folder, "Folder of the benchmark; its folder diagnoses keeps the diagnoses for the next run")
        ->type_name("FOLDER")
        ->required();
    command->add_option("--seal", options.hash, "Hash that fusee blind make printed; default: the hash in seal.txt");
    command->add_option("--model", arguments->model, "Benchmark made with --plant model; its score is shown for comparison")
        ->type_name("FOLDER");
    command->add_option("--limit", options.limit, "Number of cases, from the first; 0: all")->capture_default_str();
    command->add_flag("--again", options.again, "Repeat existing diagnoses");
    add_jobs(*command, options.jobs, "Number of cases diagnosed at the same time; 0: one per processor. The score does not depend on it");
    add_out(*command, arguments->out, "Folder of score.json and score.html");
    add_force(*command, options.force);
    command->footer(
        "Example:\n  fusee blind score blind --seal sha256:HASH --out blind/score\n\n"
        "Exit code: 0 the score is written, 2 bad input or a broken seal, 3 internal error, "
        "130 stopped by Ctrl-C: the finished diagnoses stay.");
    command->callback([arguments, &action] { action = [arguments](Reply& reply) { return score(*arguments, reply); }; });
}

}  // namespace

void add_blind(CLI::App& app, Action& action) {
    CLI::App* command = add_command(app, "blind");
    command->require_subcommand(1);
    command->footer(
        "Example:\n  fusee blind make --seed 1 --cases 20 --out blind\n\nHelp of the steps: fusee blind make --help, fusee blind score "
        "--help");
    add_blind_make(*command, action);
    add_blind_score(*command, action);
}

}  // namespace fusee::app
