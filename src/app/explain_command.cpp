#include <CLI/CLI.hpp>

#include "arguments.h"
#include "commands.h"
#include "explain/entry.h"
#include "reply.h"

namespace fusee::app {

namespace {

int run_explain(const std::vector<std::string>& names, Reply& reply) {
    Json all = Json::array();
    bool first = true;
    for (const std::string& name : names)
        for (const Entry& entry : explain(name)) {
            all.push_back(entry.json);
            reply.print((first ? "" : "\n") + entry_text(entry, core::terminal_columns()));
            first = false;
        }
    reply.result = {{"entries", all}};
    return 0;
}

}  // namespace

void add_explain(CLI::App& app, Action& action) {
    const auto [command, names] = add_command(app, action, "explain", run_explain);
    command->add_option("name", *names, "Id of a rule, finding or effect, key or table of a profile, term or symbol of the glossary")
        ->required()
        ->type_name("NAME");
    command->footer(
        "Example:\n  fusee explain cable.bend_ratio\n  fusee explain law.start_torque_Nm\n  fusee explain gear.coulomb\n"
        "  fusee explain dead-band\n\n"
        "Exit code: 0, or 2 for a name that nothing has (near ones are named).");
}

}  // namespace fusee::app
