#include "arguments.h"
#include "fusee/pipeline/budget.h"
#include "fusee/report/budget.h"
#include "places.h"

namespace fusee::app {

namespace {

struct BudgetArguments {
    std::filesystem::path profile;
    int draws = 1000;
    double wanted_percent = 5.0;
};

int run_budget(const BudgetArguments& arguments, Reply& reply) {
    const profile::Profile profile = profile::read_profile(arguments.profile);
    return with_places(profile, [&] {
        const auto budget = pipeline::find_budget(profile, arguments.draws);
        if (!budget) {
            reply.show(budget.refusal());
            return kRefused;
        }
        const report::BudgetTitle title{profile.name, checks::to_string(profile.process.kind)};
        const double wanted = 0.01 * arguments.wanted_percent;
        if (reply.json())
            reply.set_all(report::budget_json(title, *budget, wanted));
        else
            reply.print(report::budget_text(title, *budget, wanted));
        return 0;
    });
}

}  // namespace

void add_budget(CLI::App& app, Action& action) {
    constexpr int kMostDraws = 100'000, kLeastDraws = 20;
    const auto [command, arguments] = add_command(app, action, "budget", run_budget);
    add_profile(*command, arguments->profile, "Profile (*.toml); its table [budget] and its process state the tolerances");
    add_number(*command, "--draws", arguments->draws, kLeastDraws, kMostDraws,
               "Number of joints to sample; a single spring is computed to first order");
    add_number(*command, "--wanted", arguments->wanted_percent, 0.01, 100.0,
               "Wanted error of the torque, 5 to 95 % of joints, to both sides [%]");
    command->footer(
        "Example:\n  fusee budget profiles/pnrvsa.toml --wanted 3\n\n"
        "Exit code: 0 the budget is stated, 1 a cam cannot be designed, 2 bad input (file, line and key are named), 3 internal error.");
}

}  // namespace fusee::app
