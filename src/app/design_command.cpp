#include <algorithm>

#include "arguments.h"
#include "fusee/core/progress.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/profile.h"
#include "fusee/report/findings.h"
#include "fusee/report/rule_counts.h"
#include "fusee/report/search.h"
#include "fusee/search/design.h"
#include "fusee/search/one_spring.h"
#include "places.h"

namespace fusee::app {

namespace {

struct DesignArguments {
    std::filesystem::path profile, catalogue;
    bool repair = false;
    search::codesign::SearchChanges changes;
    search::codesign::RunOptions options;
};

/// A progress bar of at most 25 steps; without a terminal each step is a line.
class Steps {
public:
    explicit Steps(int generations)
        : generations_(generations), steps_(std::min(generations, 25)), progress_("design", static_cast<std::size_t>(steps_)) {}
    void reach(int generation, double best) {
        for (; shown_ < static_cast<long>(generation) * steps_ / generations_; ++shown_)
            progress_.advance(fmt::format("generation {}, best cost {:.6g}", generation, best));
    }

private:
    int generations_;
    long steps_, shown_ = 0;
    core::Progress progress_;
};

search::codesign::RunResult watched(const profile::Profile& profile, search::codesign::RunOptions options) {
    Steps steps(profile.search.generations);
    options.progress = [&steps](int generation, double best) { steps.reach(generation, best); };
    return search::codesign::find_springs(profile, options);
}

int say(const search::codesign::RunResult& result, const std::filesystem::path& folder, Reply& reply) {
    if (!result.found()) {
        if (result.interrupted) reply.warn("stopped; no springs were found so far\n");
        reply.show(result.findings);
        return result.interrupted ? kInterrupted : kRefused;
    }
    reply.result = {{"summary", result.summary}, {"folder", folder.string()}};
    reply.set("findings", report::findings_list_json(result.findings));
    for (const std::string& line : result.summary) reply.say(line + "\n");
    for (const core::Finding& finding : result.findings)
        if (core::is_broken(finding)) reply.say(fmt::format("  {}\n", core::to_line(finding)));
    if (const std::string open = report::not_judged_text(result.findings); !open.empty()) reply.say(fmt::format("  {}\n", open));
    reply.say(fmt::format("{}: {}\n", result.interrupted ? "stopped; the best springs so far" : "written", (folder / "").string()));
    return result.interrupted ? kInterrupted : 0;
}

/// Those of a search of a joint's springs have no meaning here.
void require_options_of_spring(const DesignArguments& arguments) {
    const search::codesign::SearchChanges& c = arguments.changes;
    for (const auto& [given, option] : {std::pair{c.method.has_value(), "--method"},
                                        {c.population.has_value(), "--population"},
                                        {c.seed.has_value(), "--seed"},
                                        {arguments.options.resume, "--resume"}})
        if (given)
            throw core::InvalidInput(option, "has no meaning here", "only for kind = \"joint\"; of one spring every family is searched");
}

/// The smallest part of each family of a single spring, each as a profile.
int design_spring(const DesignArguments& arguments, const profile::Profile& profile, Reply& reply) {
    require_options_of_spring(arguments);
    pipeline::require_parts(profile);
    core::OutputFolder output(arguments.options.out, search::codesign::result_folder(profile, arguments.options).filename(),
                              search::codesign::output_run(profile, arguments.options));
    search::one_spring::Options options{
        .front = true, .repair = arguments.repair, .jobs = arguments.options.jobs, .stop = core::interrupted};
    if (arguments.changes.generations) options.generations = *arguments.changes.generations;
    if (!arguments.catalogue.empty()) options.catalogue = spring::read_catalogue(arguments.catalogue);
    core::Progress progress("design", (options.repair ? 2 : 1) * options.families.size() + 1);
    options.progress = [&](const std::string& family) { progress.advance(family); };
    const std::vector<search::one_spring::Family> families = search::one_spring::find_smallest(profile, options);
    reply.set("families", report::families_json(families));
    const search::one_spring::Family* best = search::one_spring::smallest(families);
    reply.say(report::families_text(profile.name, families, !arguments.repair));
    if (best == nullptr) return kRefused;
    for (const search::one_spring::Family& family : families)
        if (family.found())
            core::write_file(output.path() / (family.name + ".toml"),
                             profile::to_commented_toml(search::codesign::moved(*family.profile, output.target())));
    core::write_file(output.path() / "front.csv", report::fronts_csv(families));
    output.commit();
    reply.result["folder"] = output.target().string();
    reply.result["smallest"] = best->name;
    reply.say(fmt::format("written: {}; the smallest is {}.toml\n", (output.target() / "").string(), best->name));
    return 0;
}

int design(const DesignArguments& arguments, Reply& reply) {
    require_thread();
    profile::Profile profile = profile::read_profile(arguments.profile);
    search::codesign::change_search(profile.search, arguments.changes);
    return with_places(profile, [&] {
        if (profile.is_spring()) return design_spring(arguments, profile, reply);
        if (arguments.repair)
            throw core::InvalidInput("--repair", "has no meaning here",
                                     "only for kind = \"spring\"; of a joint `fusee init --repair` has it");
        if (!arguments.catalogue.empty())
            throw core::InvalidInput("--catalogue", arguments.catalogue.string(),
                                     "only for kind = \"spring\"; of a joint the key co_design.catalogue names it");
        core::OutputFolder output(arguments.options.out, search::codesign::result_folder(profile, arguments.options).filename(),
                                  search::codesign::output_run(profile, arguments.options));
        const search::codesign::RunResult result = watched(profile, arguments.options);
        if (result.found()) {
            report::write_search(result, output.path());
            output.commit();
        }
        return say(result, output.target(), reply);
    });
}

}  // namespace

void add_design(CLI::App& app, Action& action) {
    constexpr int kMost = 1'000'000;
    const auto [command, arguments] = add_command(app, action, "design", design);
    add_profile(*command, arguments->profile, "Profile (*.toml); [design] and the table of the method state the goal");
    command->add_option("--method", arguments->changes.method, "Method of the search; replaces that of the profile")
        ->check(one_of({design::kMethodNames.begin(), design::kMethodNames.end()}));
    add_out(*command, arguments->options.out, "Folder of NAME-design and NAME-design.checkpoint");
    command->add_option("--population", arguments->changes.population, "Size of a generation; replaces that of the profile")
        ->check(number_within(8, 100000));
    command->add_option("--generations", arguments->changes.generations, "Number of generations; replaces that of the profile")
        ->check(number_within(1, kMost));
    command->add_option("--seed", arguments->changes.seed, "Seed; replaces that of the profile. The same seed gives the same result")
        ->check(number_within(0, 1'000'000'000));
    add_catalogue(*command, arguments->catalogue,
                  "Springs on sale, of which each part of one spring takes one; default: springs are wound");
    command->add_flag("--repair", arguments->repair,
                      "Of one spring: where no family has a part, its law is changed as little as possible, shown beside the wanted one");
    add_jobs(*command, arguments->options.jobs, "Number of threads; 0: one per processor. The result does not depend on it");
    command->add_flag("--resume", arguments->options.resume, "Continue a stopped search from its checkpoint");
    add_force(*command, arguments->options.force);
    command->footer(
        "Of one spring (kind = \"spring\") the smallest part of each family is found: spool, cable, helix, two_cables (where the torque "
        "changes its sign), roller (on a slide), arm (a roller on one), each a profile.\n"
        "Example:\n  fusee design profiles/pnrvsa.toml\n  fusee design profiles/pnrvsa.toml --generations 1000 --resume\n\n"
        "Exit code: 0 springs are found, 1 no springs are found (the binding limit and a change are printed), 2 bad input (file, line and "
        "key are named), "
        "3 internal error, 130 stopped by Ctrl-C: the best springs so far are written.");
}

}  // namespace fusee::app
