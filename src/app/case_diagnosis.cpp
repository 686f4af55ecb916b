#include "case_diagnosis.h"

#include <fmt/format.h>

#include "file_kind.h"
#include "fusee/simulator/process.h"
#include "fusee/subsystem/subsystem.h"

namespace fusee::app {

namespace {

/// An error about the whole case names no file; this function names its folder.
template <class Work>
auto with_folder(const fs::path& folder, const Work& work) {
    try {
        return work();
    } catch (const core::InvalidInput& e) {
        throw core::InvalidInput(folder.string() + ": " + e.field(), e.value(), e.allowed());
    }
}

using gap_case::CaseKind;

const char* name_of(CaseKind kind) {
    return kind == CaseKind::kSimulator ? "a simulator's" : kind == CaseKind::kElement ? "an element's" : "a joint's";
}

/// Both cases are read before the first is diagnosed.
diagnosis::Diagnosis diagnosis_against(CaseKind kind, const fs::path& folder, const fs::path& other,
                                       const diagnosis::DiagnoseOptions& options, const fs::path& own_model) {
    const CaseKind other_kind = kind_with(other, own_model);
    if (kind != other_kind || kind == CaseKind::kElement)
        throw core::InvalidInput(
            "--against", fmt::format("{}: {} case, and {}: {}", other.string(), name_of(other_kind), folder.string(), name_of(kind)),
            "two cases of a joint, or two of one simulator; files of an element are held out in its own case");
    diagnosis::Diagnosis found;
    if (kind == CaseKind::kSimulator) {
        const simulator::Case own = simulator::read_case(folder, own_model), others = simulator::read_case(other, own_model);
        simulator::require_same_model(own, others);
        const simulator::Simulated model(own, simulator::start_processes(own, options.jobs)),
            other_model(others, simulator::start_processes(others, options.jobs));
        found = diagnosis::diagnose_model(model, {own.name, own.sha256}, options);
        found.against = diagnosis::against(other_model, {others.name, others.sha256}, found, options);
        return found;
    }
    const gap_case::Case own = gap_case::read_case(folder), others = gap_case::read_case(other);
    found = with_folder(folder, [&] { return diagnosis::diagnose(own, options); });
    found.against = with_folder(other, [&] { return diagnosis::against(others, found, options); });
    return found;
}

}  // namespace

CaseKind kind_with(const fs::path& folder, const fs::path& own_model) {
    return own_model.empty() ? gap_case::kind_of_case(folder) : CaseKind::kSimulator;
}

diagnosis::Diagnosis diagnosis_of(const fs::path& folder, const diagnosis::DiagnoseOptions& options, const fs::path& against,
                                  const fs::path& own_model) {
    const CaseKind kind = kind_with(folder, own_model);
    if (!against.empty()) return diagnosis_against(kind, folder, against, options, own_model);
    if (kind == CaseKind::kSimulator) {
        const simulator::Case own = simulator::read_case(folder, own_model);
        const simulator::Simulated model(own, simulator::start_processes(own, options.jobs));
        return diagnosis::diagnose_model(model, {own.name, own.sha256}, options);
    }
    if (kind == CaseKind::kElement) {
        const subsystem::Case bench = subsystem::read_case(folder);
        return with_folder(folder, [&] { return subsystem::diagnose(bench, options); });
    }
    const gap_case::Case bench = gap_case::read_case(folder);
    return with_folder(folder, [&] { return diagnosis::diagnose(bench, options); });
}

void add_model(CLI::App& command, fs::path& model) {
    command
        .add_option("--model", model, "File with [model], [parameters] and [effects] of a simulator, in place of the model of case.toml")
        ->type_name("FILE.toml")
        ->check(reads({FileKind::kCaseFile}, "a file with [model], as a case.toml has it"));
}

}  // namespace fusee::app
