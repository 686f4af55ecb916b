#pragma once
#include <functional>

namespace CLI {
class App;
}

namespace fusee::app {

class Reply;

/// The work of a parsed command line; answers through the reply and returns the exit code.
using Action = std::function<int(Reply&)>;

/// Adds the command with its group and description (catalogue.h). @pre kCommands has the name
CLI::App* add_command(CLI::App& app, const char* name);

/// Each adds its subcommand to `app` and sets `action` when the user calls it.
void add_init(CLI::App& app, Action& action);
void add_make(CLI::App& app, Action& action);
void add_watch(CLI::App& app, Action& action);
void add_batch(CLI::App& app, Action& action);
void add_query(CLI::App& app, Action& action);
void add_fix(CLI::App& app, Action& action);
void add_render(CLI::App& app, Action& action);
void add_budget(CLI::App& app, Action& action);
void add_springs(CLI::App& app, Action& action);
void add_simulate(CLI::App& app, Action& action);
void add_identify(CLI::App& app, Action& action);
void add_design(CLI::App& app, Action& action);
void add_diagnose(CLI::App& app, Action& action);
void add_predict(CLI::App& app, Action& action);
void add_case_template(CLI::App& app, Action& action);
void add_blind(CLI::App& app, Action& action);
void add_paper(CLI::App& app, Action& action);
void add_coupons(CLI::App& app, Action& action);
void add_calibrate(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_explain(CLI::App& app, Action& action);
void add_rules(CLI::App& app, Action& action);
void add_keys(CLI::App& app, Action& action);
void add_completion(CLI::App& app, Action& action);
void add_man(CLI::App& app, Action& action);

}  // namespace fusee::app
