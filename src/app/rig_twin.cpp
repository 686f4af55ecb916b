#include "rig_twin.h"

#include "arguments.h"
#include "fusee/core/provenance.h"
#include "fusee/diagnosis/diagnose.h"
#include "fusee/effects/term.h"
#include "fusee/mjcf/write.h"

namespace fusee::app {

namespace {

constexpr double kReference = 0.5;  // of the greatest load of the springs: co-contraction of the constant friction in joint.xml

gap_case::Case nominal_of(const fs::path& folder) {
    if (gap_case::kind_of_case(folder) != gap_case::CaseKind::kJoint)
        throw core::InvalidInput("--write-mjcf", folder.string(), "a case with [rig]: this one has no joint");
    return gap_case::read_nominal(folder);
}

std::string effects_of(const diagnosis::Diagnosis& found) {
    std::string text;
    for (const diagnosis::FoundEffect& effect : found.effects) {
        const std::string side = effect.cause.side == "none" ? "" : " (" + effect.cause.side + ")";
        const std::string unit = effects::find_effect_or_term(effect.cause.id).parameters.front().unit;
        text += fmt::format("{}{}{} {:.4g}{}{}", text.empty() ? "" : ", ", effect.cause.id, side, effect.parameter.value,
                            unit.empty() ? "" : " ", unit);
    }
    return text.empty() ? "no effect" : text;
}

std::vector<std::string> left_out(const diagnosis::Diagnosis& found) {
    std::vector<std::string> sentences{"noise and steps of the sensors, scatter of the friction",
                                       "the hand that damps the joint in a dead-band test: give the joint its damping"};
    for (const diagnosis::UnknownTerm& term : found.unknown_terms) sentences.push_back("the unknown effect: " + term.sentence);
    return sentences;
}

core::OutputRun with_files(core::OutputRun run) {
    run.files = {mjcf::kModelFile, mjcf::kLawsFile, mjcf::kJavaScriptFile, mjcf::kPythonFile};
    return run;
}

}  // namespace

RigTwin::RigTwin(const fs::path& folder, core::OutputRun run)
    : nominal_(nominal_of(run.source)),
      name_(fs::weakly_canonical(run.source).filename().string()),
      output_(folder, with_files(std::move(run))) {}

void RigTwin::write(const diagnosis::Diagnosis& found) {
    const joint_model::BuiltRig rig = diagnosis::built_rig(nominal_, found);
    mjcf::Twin twin = mjcf::twin_of(rig, nominal_.rig.capstan_radius, kReference * rig.reference.torque);
    twin.name = name_;
    twin.source = fmt::format("fusee {}, case {}, {}", core::version(), name_, effects_of(found));
    twin.not_expressed = left_out(found);
    mjcf::write(twin, output_.path());
    output_.commit();
}

std::string RigTwin::line() const { return fmt::format("model for MuJoCo: {}\n", (output_.target() / "").string()); }

std::optional<RigTwin> rig_twin(const fs::path& folder, const fs::path& out, core::OutputRun run) {
    if (folder.empty()) return std::nullopt;
    require_other_folder("--write-mjcf", folder, out, "--out");
    return std::optional<RigTwin>(std::in_place, folder, std::move(run));
}

void add_mjcf(CLI::App& command, fs::path& folder) {
    command
        .add_option("--write-mjcf", folder,
                    "Folder of the rig with its effects as a model for MuJoCo, with companion programs that apply the exact laws")
        ->type_name("FOLDER");
}

}  // namespace fusee::app
