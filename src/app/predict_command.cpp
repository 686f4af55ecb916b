#include "arguments.h"
#include "case_diagnosis.h"
#include "fusee/simulator/process.h"
#include "fusee/subsystem/subsystem.h"
#include "rig_twin.h"

namespace fusee::app {

namespace {

struct PredictArguments {
    fs::path folder, model, effects, inputs, out, mjcf;
    bool force = false;
};

/// Writes what a simulator of the user's own predicts. @returns the number of rows
std::size_t predict_simulator(const PredictArguments& arguments, const fs::path& inputs, const diagnosis::Diagnosis& found,
                              const fs::path& to) {
    const simulator::Case own = simulator::read_case(arguments.folder, arguments.model);
    const std::vector<simulator::Experiment> asked = simulator::read_inputs(own, inputs);
    const simulator::Simulated model(own, simulator::start_processes(own, 1));
    const inference::Setting setting = diagnosis::setting_of(model, found, arguments.effects.string());
    std::size_t rows = 0;
    try {
        const std::vector<simulator::Experiment> predicted = model.predict_at(setting, asked);
        simulator::write_runs(predicted, to);
        for (const simulator::Experiment& experiment : predicted)
            for (const simulator::Run& own_run : experiment.runs) rows += own_run.rows();
    } catch (const inference::Refusal& refusal) {
        throw core::InvalidInput("model", std::string("refused: ") + refusal.what(), "effects and inputs that it can simulate");
    }
    return rows;
}

int predict(const PredictArguments& arguments, Reply& reply) {
    const fs::path& inputs = arguments.inputs.empty() ? arguments.folder : arguments.inputs;
    for (const fs::path& measured : {inputs, arguments.folder})  // predictions have the file names of the measurements
        require_other_folder("--out", arguments.out, measured, "that of the measurements");
    const core::OutputRun run{.command = "predict", .source = arguments.folder, .force = arguments.force};
    core::OutputFolder output(arguments.out, run);
    std::optional<RigTwin> twin = rig_twin(arguments.mjcf, arguments.out, run);
    const diagnosis::Diagnosis found = arguments.effects.empty() ? diagnosis::Diagnosis{} : diagnosis::read_diagnosis(arguments.effects);
    std::size_t rows = 0;
    const gap_case::CaseKind kind = kind_with(arguments.folder, arguments.model);
    if (kind == gap_case::CaseKind::kSimulator) {
        rows = predict_simulator(arguments, inputs, found, output.path());
    } else if (kind == gap_case::CaseKind::kElement) {
        const subsystem::Case bench = subsystem::read_case(arguments.folder);
        const subsystem::Case predicted =
            subsystem::predict(bench, found, arguments.inputs.empty() ? bench : subsystem::read_inputs(bench, inputs));
        subsystem::write_rows(predicted, output.path());
        for (const subsystem::Record& record : predicted.records) rows += record.rows();
    } else {
        const gap_case::Case bench = gap_case::read_nominal(arguments.folder);
        diagnosis::require_possible(bench, found, arguments.effects.string());
        const gap_case::Rows predicted = diagnosis::predict(bench, found, gap_case::read_inputs(bench, inputs));
        gap_case::write_rows(bench, predicted, output.path());
        rows = predicted.size();
    }
    output.commit();
    if (twin) twin->write(found);  // may lie in the folder of the results: only after they are there
    const std::size_t effects = found.effects.size();
    reply.result = {{"rows", rows}, {"effects", effects}, {"folder", arguments.out.string()}};
    if (twin) reply.result["mjcf"] = arguments.mjcf.string();
    reply.say(fmt::format("{} rows predicted by the {}\nwritten: {}\n", rows,
                          effects == 0 ? "nominal model" : fmt::format("model with {} effect{}", effects, effects > 1 ? "s" : ""),
                          (arguments.out / "").string()));
    if (twin) reply.say(twin->line());
    return 0;
}

}  // namespace

void add_predict(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "predict", predict);
    add_case(*command, arguments->folder, "Folder of the gap case with the nominal rig");
    add_model(*command, arguments->model);
    command->add_option("--effects", arguments->effects, "diagnosis.json with the effects; default: the nominal model")
        ->type_name("FILE.json")
        ->check(reads_diagnosis());
    command
        ->add_option(
            "--inputs", arguments->inputs,
            "Folder of CSV files with the same names as in the case; only their input columns are read. Default: the case itself, which "
            "may be an empty template")
        ->type_name("FOLDER");
    add_out(*command, arguments->out, "Folder of the same files with predicted values in the measured columns");
    add_mjcf(*command, arguments->mjcf);
    add_force(*command, arguments->force);
    command->footer(
        "Examples:\n  fusee predict bench/monday --out /tmp/expected\n  fusee predict bench/monday --effects "
        "bench/monday/diagnosis/diagnosis.json --inputs bench/tuesday --out "
        "/tmp/predicted\n\n"
        "Exit code: 0 the predictions are written, 2 bad input (file, line and key are named), 3 internal error.");
}

}  // namespace fusee::app
