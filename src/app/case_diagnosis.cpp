#include "case_diagnosis.h"

#include <fmt/format.h>

#include "fusee/core/error.h"
#include "fusee/simulator/process.h"
#include "fusee/subsystem/subsystem.h"

namespace fusee::app {

namespace fs = std::filesystem;

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

const char* kind_of(const fs::path& folder) {
    if (simulator::is_simulator_case(folder)) return "a simulator's";
    return gap_case::is_subsystem_case(folder) ? "an element's" : "a joint's";
}

/// Both cases are read before the first is diagnosed.
diagnosis::Diagnosis diagnosis_against(const fs::path& folder, const fs::path& other, const diagnosis::DiagnoseOptions& options) {
    const std::string kind = kind_of(folder), other_kind = kind_of(other);
    if (kind != other_kind || kind == "an element's")
        throw core::InvalidInput("--against", fmt::format("{}: {} case, and {}: {}", other.string(), other_kind, folder.string(), kind),
                                 "two cases of a joint, or two of one simulator; files of an element are held out in its own case");
    diagnosis::Diagnosis found;
    if (simulator::is_simulator_case(folder)) {
        const simulator::Case own = simulator::read_case(folder), others = simulator::read_case(other);
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

bool is_joint_case(const fs::path& folder) { return !simulator::is_simulator_case(folder) && !gap_case::is_subsystem_case(folder); }

diagnosis::Diagnosis diagnosis_of(const fs::path& folder, const diagnosis::DiagnoseOptions& options, const fs::path& against) {
    if (!against.empty()) return diagnosis_against(folder, against, options);
    if (simulator::is_simulator_case(folder)) {
        const simulator::Case own = simulator::read_case(folder);
        const simulator::Simulated model(own, simulator::start_processes(own, options.jobs));
        return diagnosis::diagnose_model(model, {own.name, own.sha256}, options);
    }
    if (gap_case::is_subsystem_case(folder)) {
        const subsystem::Case bench = subsystem::read_case(folder);
        return with_folder(folder, [&] { return subsystem::diagnose(bench, options); });
    }
    const gap_case::Case bench = gap_case::read_case(folder);
    return with_folder(folder, [&] { return diagnosis::diagnose(bench, options); });
}

}  // namespace fusee::app
