#include "arguments.h"
#include "fusee/batch/batch.h"
#include "fusee/core/progress.h"
#include "output.h"
#include "page_server.h"

namespace fusee::app {

namespace {

struct WatchArguments {
    std::filesystem::path profile;
    batch::WatchOptions options;
    bool serve = false;
    int port = 0;
};

int run_watch(const WatchArguments& arguments, Reply& reply) {
    require_thread();
    const std::unique_ptr<PageServer> pages = arguments.serve ? std::make_unique<PageServer>(arguments.port) : nullptr;
    batch::WatchOptions options = arguments.options;
    options.stop = core::interrupted;
    options.say = [&reply](const std::string& text) {
        reply.say(text + "\n");
        (void)flush_out();
    };
    if (pages) {
        options.say("page: " + pages->address() + " (it reloads itself; only this machine sees it)");
        options.answered = [&pages](const std::string& verdict) { pages->tell(verdict); };
        options.made = [&pages](const std::filesystem::path& folder) { pages->show(folder); };
    }
    batch::watch_profile(arguments.profile, options);
    reply.fail("stopped");
    reply.say("stopped\n");
    return kInterrupted;
}

}  // namespace

void add_watch(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "watch", run_watch);
    add_profile(*command, arguments->profile, "Profile (*.toml); the CSV files that it names are watched too");
    add_out(*command, arguments->options.folder.out, "Folder of the results, as of make");
    command->add_flag("--serve", arguments->serve, "Serve out/NAME to a browser on this machine (127.0.0.1); the page reloads itself");
    add_number(*command, "--port", arguments->port, 0, 65535, "Port of --serve; 0: a free one");
    add_force(*command, arguments->options.folder.force);
    command->footer(
        "Example:\n  fusee watch profiles/pnrvsa.toml\n  fusee watch my_joint.toml --serve\n\n"
        "Exit code: 130 stopped by Ctrl-C (a make that has not ended leaves no file), 2 bad input: there is no such profile, or the port "
        "is\n"
        "taken; 3 internal error. A bad profile is reported, and watching goes on.");
}

}  // namespace fusee::app
