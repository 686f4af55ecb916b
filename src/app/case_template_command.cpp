#include <fmt/format.h>

#include <memory>

#include "arguments.h"
#include "commands.h"
#include "exit_codes.h"
#include "fusee/core/output_folder.h"
#include "fusee/pipeline/case_template.h"
#include "places.h"

namespace fusee::app {

namespace fs = std::filesystem;

namespace {

struct CaseTemplateArguments {
    fs::path profile, out;
    bool force = false;
    pipeline::CaseTemplateOptions options;
};

int write_template(const CaseTemplateArguments& arguments, Reply& reply) {
    const profile::Profile profile = profile::read_profile(arguments.profile);
    core::OutputFolder output(
        arguments.out,
        {.command = "case-template", .source = arguments.profile, .force = arguments.force, .sheets = gap_case::case_template_files()});
    const auto made = with_places(profile, [&] { return pipeline::case_template(profile, arguments.options); });
    if (!made) {
        reply.show(made.refusal());
        return kRefused;
    }
    gap_case::write_case_template(*made, output.path());
    output.commit();
    const std::size_t points = gap_case::set_points(*made).size();
    reply.result = {{"case", made->name}, {"set_points", points}, {"folder", arguments.out.string()}};
    reply.say(fmt::format("{}: an empty case with {} set points; begin with BENCH.md\nwritten: {}\n", made->name, points,
                          (arguments.out / "").string()));
    return 0;
}

}  // namespace

void add_case_template(CLI::App& app, Action& action) {
    const auto arguments = std::make_shared<CaseTemplateArguments>();
    CLI::App* command = app.add_subcommand(
        "case-template",
        "Write an empty gap case for the joint of a profile: nominal rig, set points and sheets to fill in during the tests");
    command->add_option("profile", arguments->profile, "Profile (*.toml) with the base springs of the parts")
        ->type_name("FILE.toml")
        ->required();
    command->add_option("-o,--out", arguments->out, "Folder of the case; filled-in sheets are never replaced")
        ->type_name("FOLDER")
        ->required();
    add_force(*command, arguments->force);
    command->footer(
        "Example:\n  fusee case-template profiles/pnrvsa.toml --out bench/monday\n\n"
        "Exit code: 0 the case is written, 1 the law is not possible (the binding limit and the nearest feasible change are printed),\n"
        "2 bad input (file, line and key are named), 3 internal error.");
    command->callback([arguments, &action] { action = [arguments](Reply& reply) { return write_template(*arguments, reply); }; });
}

}  // namespace fusee::app
