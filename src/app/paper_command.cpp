#include <fmt/format.h>

#include <memory>

#include "arguments.h"
#include "commands.h"
#include "fusee/core/progress.h"
#include "fusee/paper/run.h"

namespace fusee::app {

namespace {

constexpr int kRefused = 1, kInterrupted = 130;

paper::Result watched(paper::Options options) {
    core::Progress progress("paper", paper::kPieces);
    options.note = [&progress](const std::string& piece) { progress.advance(piece); };
    return paper::run(options);
}

int make_paper(const paper::Options& options) {
    core::catch_interrupts();
    require_thread();
    const paper::Result result = watched(options);
    for (const core::Finding& finding : result.findings) fmt::print(stderr, "{}\n", core::to_line(finding));
    if (result.interrupted) {
        fmt::print(stderr, "stopped: nothing was written\n");
        return kInterrupted;
    }
    if (!result.made) return kRefused;
    fmt::print("{}written: {}\n", result.summary, (result.folder / "paper.html").string());
    return 0;
}

}  // namespace

void add_paper(CLI::App& app, Action& action) {
    const auto options = std::make_shared<paper::Options>();
    CLI::App* command =
        app.add_subcommand("paper", "Make every table and figure of the paper anew: out/paper with paper.html and a CSV file for each");
    command->add_option("-o,--out", options->out, "Folder that gets the folder paper")->capture_default_str();
    command->add_option("--profiles", options->profiles, "Folder of the shipped profiles")->capture_default_str();
    add_jobs(*command, options->jobs, "Threads; 0 = one for each processor; no influence on the result");
    add_force(*command, options->force);
    command->footer(
        "Example:\n  fusee paper\n\n"
        "Exit code: 0 all made, 1 a law cannot be (the binding limit and the nearest feasible change are printed),\n"
        "2 bad input (file, line and key are named), 3 a failure inside, 130 stopped by Ctrl-C: nothing is written.");
    command->callback([options, &action] { action = [options] { return make_paper(*options); }; });
}

}  // namespace fusee::app
