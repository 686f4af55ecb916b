#include "arguments.h"
#include "fusee/core/file.h"
#include "fusee/core/folder.h"
#include "fusee/gap_case/break_away.h"
#include "fusee/report/identification.h"

namespace fusee::app {

namespace {

struct IdentifyArguments {
    std::filesystem::path csv, out = "out";
    bool force = false;
    std::vector<std::string> columns;
};

int identify(const IdentifyArguments& arguments, Reply& reply) {
    core::OutputFolder output(arguments.out, "identify-" + arguments.csv.stem().string(),
                              {.command = "identify",
                               .source = arguments.csv,
                               .force = arguments.force,
                               .files = {"identification.json", "identification.html"}});
    const std::string bytes = core::read_file(arguments.csv, gap_case::kLargestBreakAwayFile);
    const gap_case::Identification found{
        arguments.csv.stem().string(), core::sha256_hex(bytes),
        gap_case::identify_friction(gap_case::parse_break_away(bytes, arguments.csv.string(), core::CsvMapping::of(arguments.columns)))};
    const std::string json = report::identification_json(found);
    core::write_file(output.path() / "identification.json", json);
    core::write_file(output.path() / "identification.html", report::identification_html(found));
    output.commit();
    reply.result = {{"folder", output.target().string()}};
    reply.set("identification", json);
    reply.say(fmt::format("{}\nwritten: {}/identification.html, identification.json\n", report::identification_text(found),
                          output.target().string()));
    return found.friction.law ? 0 : 1;
}

}  // namespace

void add_identify(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "identify", identify);
    command
        ->add_option("csv", arguments->csv,
                     "CSV file with the columns side,direction,motor_torque_Nm,load_torque_Nm; direction is drive or backdrive")
        ->type_name("FILE.csv")
        ->check(reads({FileKind::kBreakAway}, "a CSV file of break-away tests"))
        ->required();
    add_out(*command, arguments->out, "Folder of the results; each file gets a folder in it");
    add_columns(*command, arguments->columns);
    add_force(*command, arguments->force);
    command->footer(
        "Example:\n  fusee identify profiles/examples/break_away.csv\n\n"
        "Exit code: 0 a friction law is found, 1 no friction law fits the rows, or no motor has both directions (the result is written "
        "nevertheless), "
        "2 bad input (file, line and column are named), 3 internal error.");
}

}  // namespace fusee::app
