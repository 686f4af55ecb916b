#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <system_error>
#include <vector>

#include "commands.h"
#include "fusee/core/error.h"
#include "fusee/core/progress.h"
#include "fusee/core/provenance.h"

namespace {
constexpr int kBadInput = 2, kFailed = 3, kInterrupted = 130;
}

int main(int argc, char** argv) {
    using namespace fusee;
    CLI::App app("fusee turns the spring energies of a variable-stiffness joint into cams that a shop can print or machine", "fusee");
    app.set_version_flag("--version", core::version());
    app.require_subcommand(0, 1);  // none is refused below: CLI11 would pass over a wrong word
    app.footer("Example:\n  fusee make profiles/pnrvsa.toml\n\nHelp on a command: fusee COMMAND --help");
    app::Action action;
    app::add_make(app, action);
    app::add_fix(app, action);
    app::add_simulate(app, action);
    app::add_identify(app, action);
    app::add_design(app, action);
    app::add_diagnose(app, action);
    app::add_predict(app, action);
    app::add_case_template(app, action);
    app::add_blind(app, action);
    app::add_paper(app, action);
    app::add_coupons(app, action);
    app::add_calibrate(app, action);
    app::add_check(app, action);
    app::add_rules(app, action);
    app::add_lists(app, action);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : kBadInput;
    }
    if (!action) {
        std::vector<std::string> commands;
        for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) commands.push_back(command->get_name());
        fmt::print(stderr, "A command is required: {}\nRun with --help for more information.\n", fmt::join(commands, ", "));
        return kBadInput;
    }
    try {
        return action();
    } catch (const core::InvalidInput& e) {
        fmt::print(stderr, "fusee: {}\n", e.what());
        return kBadInput;
    } catch (const core::IoError& e) {
        fmt::print(stderr, "fusee: {}\n", e.what());
        return kBadInput;
    } catch (const std::system_error& e) {  // a full disk, a folder that is a file
        fmt::print(stderr, "fusee: {}\n", e.what());
        return kBadInput;
    } catch (const core::Stopped&) {
        fmt::print(stderr, "stopped: nothing was written\n");
        return kInterrupted;
    } catch (const std::exception& e) {
        fmt::print(stderr, "fusee: a failure inside, please report it: {}\n", e.what());
        return kFailed;
    }
}
