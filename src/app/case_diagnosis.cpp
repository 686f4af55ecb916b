#include "case_diagnosis.h"

#include "fusee/core/error.h"
#include "fusee/simulator/process.h"
#include "fusee/subsystem/subsystem.h"

namespace fusee::app {

namespace fs = std::filesystem;

namespace {

/// An error about the whole case names no file; this function names its folder.
template <class Work>
diagnosis::Diagnosis with_folder(const fs::path& folder, const Work& work) {
    try {
        return work();
    } catch (const core::InvalidInput& e) {
        throw core::InvalidInput(folder.string() + ": " + e.field(), e.value(), e.allowed());
    }
}

}  // namespace

bool is_joint_case(const fs::path& folder) { return !simulator::is_simulator_case(folder) && !gap_case::is_subsystem_case(folder); }

diagnosis::Diagnosis diagnosis_of(const fs::path& folder, const diagnosis::DiagnoseOptions& options) {
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
