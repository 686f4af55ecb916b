#include <mutex>

#include "arguments.h"
#include "case_diagnosis.h"
#include "fusee/core/file.h"
#include "fusee/core/progress.h"
#include "redesign_step.h"
#include "rig_twin.h"

namespace fusee::app {

namespace {

struct DiagnoseArguments {
    fs::path folder, model, against, out, profile, corrected, mjcf;
    bool force = false;
    unsigned jobs = 0;
};

/// A progress bar whose length is known after the first step; Ctrl-C stops the work between two steps.
class Watched {
public:
    /// @param cases that are diagnosed one after the other
    explicit Watched(std::size_t cases) : cases_(cases) {}
    void operator()(std::size_t, std::size_t total, const std::string& what) {
        if (core::interrupted()) throw core::Stopped();
        const std::scoped_lock lock(mutex_);
        if (!progress_) progress_.emplace("diagnose", cases_ * total);
        progress_->advance(what);
    }

private:
    std::size_t cases_;
    std::mutex mutex_;
    std::optional<core::Progress> progress_;
};

core::OutputRun run_of(const DiagnoseArguments& arguments) {
    return {.command = "diagnose", .source = arguments.folder, .force = arguments.force, .files = {"diagnosis.html", "diagnosis.json"}};
}

int diagnose(const DiagnoseArguments& arguments, Reply& reply) {
    require_thread();
    const RedesignStep redesign = redesign_step(arguments.profile, arguments.corrected, arguments.folder, arguments.force);
    core::OutputFolder output(arguments.out, run_of(arguments));
    std::optional<RigTwin> twin = rig_twin(arguments.mjcf, arguments.out, run_of(arguments));
    const RigJoint joint = rig_joint(arguments.profile, arguments.folder);
    Watched watched(arguments.against.empty() ? 1 : 2);
    const diagnosis::Diagnosis found =
        diagnosis_of(arguments.folder, {arguments.jobs, std::ref(watched)}, arguments.against, arguments.model);
    const std::string json = report::full_diagnosis_json(found);
    core::write_file(output.path() / "diagnosis.json", json);
    Redesigned redesigned;
    const auto write_page = [&] {
        core::write_file(output.path() / "diagnosis.html", report::diagnosis_html(found, redesigned.json, joint.scene));
    };
    if (redesign) try {
            redesigned = redesign(found, output.path());
        } catch (const core::InvalidInput&) {  // a value that no profile can hold: the diagnosis is written nevertheless
            write_page();
            output.commit();
            throw;
        }
    write_page();
    output.commit();
    if (twin) twin->write(found);  // may lie in the folder of the results: only after they are there
    reply.result = {{"folder", arguments.out.string()}};
    if (twin) reply.result["mjcf"] = arguments.mjcf.string();
    reply.set("diagnosis", json);
    if (redesign) reply.set("redesign", redesigned.json);
    const std::string unshown = joint.refusal.empty() ? "" : "joint in 3D: not shown, " + joint.refusal + "\n";
    reply.say(fmt::format("{}{}{}written: {}/diagnosis.html, diagnosis.json{}\n", report::diagnosis_text(found), redesigned.text, unshown,
                          arguments.out.string(), redesign ? ", redesign.json" : ""));
    if (!found.next.empty() && kind_with(arguments.folder, arguments.model) == gap_case::CaseKind::kJoint)
        reply.say("sheets for the next measurement: fusee case-template CASE --next diagnosis.json --out FOLDER\n");
    if (twin) reply.say(twin->line());
    return 0;
}

}  // namespace

void add_diagnose(CLI::App& app, Action& action) {
    const auto [command, arguments] = add_command(app, action, "diagnose", diagnose);
    add_case(*command, arguments->folder, "Folder of a gap case: case.toml and one CSV file per experiment");
    add_out(*command, arguments->out, "Folder of diagnosis.json and diagnosis.html");
    command
        ->add_option("--against", arguments->against,
                     "Folder of another case of the same joint or simulator (another unit, gain, load or day): which causes hold there")
        ->type_name("FOLDER")
        ->check(reads_case());
    add_model(*command, arguments->model);
    command->add_option("--profile", arguments->profile, "Profile of the rig: the page shows its joint in 3D, the faulty place marked")
        ->type_name("FILE.toml")
        ->check(reads_profile());
    command
        ->add_option("--write-profile", arguments->corrected,
                     "File of the profile that suits the rig as diagnosed, with --profile; fusee make turns it into new cams")
        ->type_name("FILE.toml");
    add_mjcf(*command, arguments->mjcf);
    add_jobs(*command, arguments->jobs, "Number of threads; 0: one per processor. The result does not depend on it");
    add_force(*command, arguments->force);
    command->footer(
        "Example:\n  fusee diagnose bench/monday --out bench/monday/diagnosis\n\n"
        "Exit code: 0 a verdict is reached: identified, none, ambiguous, unknown, inconclusive or "
        "partly_explained, 2 bad input (file, line and key are named), 3 internal error, 130 stopped by Ctrl-C: nothing is written.");
}

}  // namespace fusee::app
