#include "arguments.h"
#include "fusee/core/folder.h"
#include "fusee/core/progress.h"
#include "fusee/paper/paper.h"
#include "fusee/report/paper.h"

namespace fusee::app {

namespace {

struct PaperArguments {
    paper::PaperOptions options;
    std::filesystem::path out = "out";  // the result is out/paper, complete or absent
    bool force = false;
};

paper::Result watched_paper(paper::PaperOptions options) {
    core::Progress progress("paper", paper::kPieces);
    options.note = [&progress](const std::string& piece) { progress.advance(piece); };
    return paper::run(options);
}

int make_paper(const PaperArguments& arguments, Reply& reply) {
    require_thread();
    core::OutputFolder output(
        arguments.out, "paper",
        {.command = "paper", .source = arguments.options.profiles, .force = arguments.force, .files = {"paper.html", "paper.json"}});
    const paper::Result result = watched_paper(arguments.options);
    reply.show(result.findings);
    if (result.interrupted) throw core::Stopped();
    if (!result.paper) return kRefused;
    report::write_paper(*result.paper, output.path());
    output.commit();
    reply.result["folder"] = output.target().string();
    reply.set("paper", report::paper_json(*result.paper));
    reply.say(fmt::format("{}written: {}\n", report::paper_text(*result.paper), (output.target() / "paper.html").string()));
    return 0;
}

}  // namespace

void add_paper(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "paper", make_paper);
    add_out(*command, arguments->out, "Folder that contains the result, the folder paper");
    command->add_option("--profiles", arguments->options.profiles, "Folder of the shipped profiles")
        ->type_name("FOLDER")
        ->capture_default_str();
    add_jobs(*command, arguments->options.jobs, "Number of threads; 0: one per processor. The result does not depend on it");
    add_force(*command, arguments->force);
    command->footer(
        "Example:\n  fusee paper\n\n"
        "Exit code: 0 all is reproduced, 1 a law is not possible (the binding limit and the nearest feasible change are printed), "
        "2 bad input (file, line and key are named), 3 internal error, 130 stopped by Ctrl-C: nothing is written.");
}

}  // namespace fusee::app
