#pragma once
#include "fusee/core/folder.h"
#include "fusee/report/search.h"

namespace fusee::search::codesign {

/// A search and the folder with its files, as `fusee design` leaves it.
struct Written : RunResult {
    std::filesystem::path folder;  ///< empty: nothing was written
};
inline Written written(RunResult (*search)(const profile::Profile&, const RunOptions&), const profile::Profile& profile,
                       const RunOptions& options) {
    core::OutputFolder output(result_folder(profile, options), output_run(profile, options));
    Written all{search(profile, options), {}};
    if (!all.found()) return all;
    report::write_search(all, output.path());
    output.commit();
    all.folder = output.target();
    return all;
}

}  // namespace fusee::search::codesign
