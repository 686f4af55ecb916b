#include "arguments.h"
#include "fusee/core/folder.h"
#include "fusee/diagnosis/diagnose.h"
#include "fusee/pipeline/rig.h"
#include "places.h"

namespace fusee::app {

namespace {

struct CaseTemplateArguments {
    fs::path source, next, out;
    bool force = false;
};

core::OutputRun template_run_of(const CaseTemplateArguments& arguments) {
    return {.command = "case-template", .source = arguments.source, .force = arguments.force, .sheets = gap_case::case_template_files()};
}

void say_written(const CaseTemplateArguments& arguments, const std::string& name, std::size_t points, Reply& reply) {
    reply.result = {{"case", name}, {"set_points", points}, {"folder", arguments.out.string()}};
    reply.say(fmt::format("{}: an empty case with {} set points; begin with BENCH.md\nwritten: {}\n", name, points,
                          (arguments.out / "").string()));
}

/// All six experiments of the joint of a profile.
int write_template(const CaseTemplateArguments& arguments, Reply& reply) {
    const profile::Profile profile = profile::read_profile(arguments.source);
    core::OutputFolder output(arguments.out, template_run_of(arguments));
    const auto made = with_places(profile, [&] { return pipeline::case_template(profile); });
    if (!made) {
        reply.show(made.refusal());
        return kRefused;
    }
    gap_case::write_case_template(*made, output.path());
    output.commit();
    say_written(arguments, made->name, gap_case::set_points(*made).size(), reply);
    return 0;
}

/// The one measurement that a diagnosis of a case asks for.
int write_next(const CaseTemplateArguments& arguments, Reply& reply) {
    require_other_folder("--out", arguments.out, arguments.source, "that of the case");
    const gap_case::Case measured = gap_case::read_case(arguments.source);
    core::OutputFolder output(arguments.out, template_run_of(arguments));
    const diagnosis::NextCase next = diagnosis::next_case(measured, diagnosis::read_diagnosis(arguments.next), arguments.next.string());
    gap_case::write_case_template(next.empty, next.set_points, output.path());
    output.commit();
    reply.say(next.experiment.text + "\n");
    say_written(arguments, next.empty.name, next.set_points.size(), reply);
    return 0;
}

int write_case(const CaseTemplateArguments& arguments, Reply& reply) {
    return arguments.next.empty() ? write_template(arguments, reply) : write_next(arguments, reply);
}

}  // namespace

void add_case_template(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "case-template", write_case);
    command
        ->add_option("profile", arguments->source,
                     "Profile (*.toml) with the base springs of the parts; with --next: the folder of the case")
        ->type_name("FILE.toml")
        ->check(reads({FileKind::kProfile, FileKind::kCaseFolder}, "a profile; with --next the folder of a case"))
        ->required();
    command
        ->add_option(
            "--next", arguments->next,
            "diagnosis.json of a case: write only the measurement that it asks for, which decides between causes or confirms an unknown "
            "effect")
        ->type_name("FILE.json")
        ->check(reads_diagnosis());
    add_out(*command, arguments->out, "Folder of the case; filled-in sheets are never replaced");
    add_force(*command, arguments->force);
    command->footer(
        "Examples:\n  fusee case-template profiles/pnrvsa.toml --out bench/monday\n"
        "  fusee case-template bench/monday --next found/diagnosis.json --out bench/tuesday\n\n"
        "Exit code: 0 the case is written, 1 the law is not possible (the binding limit and the nearest feasible change are printed), "
        "2 bad input (file, line and key are named), 3 internal error.");
}

}  // namespace fusee::app
