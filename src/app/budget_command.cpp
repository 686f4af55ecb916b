#include <fmt/format.h>

#include <array>
#include <memory>

#include "arguments.h"
#include "commands.h"
#include "exit_codes.h"
#include "fusee/core/error.h"
#include "fusee/pipeline/budget.h"
#include "fusee/report/budget.h"
#include "numbers.h"
#include "places.h"

namespace fusee::app {

namespace {

struct BudgetArguments {
    std::filesystem::path profile;
    int draws = 1000;
    double wanted_percent = 5.0;
};

int refuse_budget(const core::Findings& refusal, Reply& reply) {
    reply.show(refusal);
    return kRefused;
}

int budget_of_profile(const BudgetArguments& arguments, const profile::Profile& profile, Reply& reply) {
    const auto design = pipeline::resolve(profile);
    if (!design) return refuse_budget(design.refusal(), reply);
    const auto series = pipeline::design_cam(cam::PartKind::kSeries, *design),
               parallel = pipeline::design_cam(cam::PartKind::kParallel, *design);
    if (!series) return refuse_budget(series.refusal(), reply);
    if (!parallel) return refuse_budget(parallel.refusal(), reply);
    const auto subject = pipeline::budget_subject(*design, {&*series, &*parallel});
    if (!subject) throw core::InvalidInput("k_pe.family", "\"roller\"", "\"cable\": errors of a cam with a roller are not modelled");
    const profile::Rig& rig = profile.rig;
    const design::budget::Budget budget = design::budget::budget_of(
        *subject, std::array{rig.least_torque, rig.peak_torque, rig.overdrive_torque}, {.draws = arguments.draws});
    const report::BudgetTitle title{profile.name, checks::to_string(profile.process.kind)};
    const double wanted = 0.01 * arguments.wanted_percent;
    if (reply.json())
        reply.set_all(report::budget_json(title, budget, wanted));
    else
        reply.print(report::budget_text(title, budget, wanted));
    return 0;
}

int run_budget(const BudgetArguments& arguments, Reply& reply) {
    const profile::Profile profile = profile::read_profile(arguments.profile);
    return with_places(profile, [&] {
        pipeline::require_joint(profile, "an error budget");
        pipeline::require_parts(profile);
        return budget_of_profile(arguments, profile, reply);
    });
}

}  // namespace

void add_budget(CLI::App& app, Action& action) {
    constexpr int kMostDraws = 100'000, kLeastDraws = 20;
    const auto arguments = std::make_shared<BudgetArguments>();
    CLI::App* command = add_command(app, "budget");
    command->add_option("profile", arguments->profile, "Profile (*.toml); its table [budget] and its process state the tolerances")
        ->type_name("FILE.toml")
        ->required();
    command->add_option("--draws", arguments->draws, "Number of joints to sample")
        ->check(number_within(kLeastDraws, kMostDraws))
        ->capture_default_str();
    command->add_option("--wanted", arguments->wanted_percent, "Wanted error of the torque, 5 to 95 % of joints, to both sides [%]")
        ->check(number_within(0.01, 100.0))
        ->capture_default_str();
    command->footer(
        "Example:\n  fusee budget profiles/pnrvsa.toml --wanted 3\n\n"
        "Exit code: 0 the budget is stated, 1 a cam cannot be designed, 2 bad input (file, line and key are named), 3 internal error.");
    command->callback([arguments, &action] { action = [arguments](Reply& reply) { return run_budget(*arguments, reply); }; });
}

}  // namespace fusee::app
