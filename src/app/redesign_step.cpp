#include "redesign_step.h"

#include <fmt/format.h>

#include "fusee/core/destination.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/report/redesign.h"
#include "fusee/search/redesign.h"
#include "fusee/subsystem/subsystem.h"
#include "made_parts.h"
#include "places.h"

namespace fusee::app {

namespace fs = std::filesystem;

namespace {

/// @param option the one that a case without a joint makes useless. @throws core::InvalidInput if case and profile are not of one rig
gap_case::Case case_of_rig(const fs::path& folder, const profile::Profile& profile, const char* option) {
    if (gap_case::is_subsystem_case(folder))
        throw core::InvalidInput(option, folder.string(), "a case with [rig]: a subsystem case is no whole joint");
    gap_case::Case gap_case = gap_case::read_case(folder);
    with_places(profile, [&] { (void)search::redesign::require_same_rig(profile, gap_case); });
    return gap_case;
}

}  // namespace

RedesignStep::RedesignStep(const fs::path& profile, const fs::path& file, const fs::path& case_folder, bool force)
    : file_(file), force_(force), toml_(core::read_file(profile, profile::kLargestFile)), profile_(profile::parse_profile(toml_, profile)) {
    if (fs::weakly_canonical(file) == fs::weakly_canonical(profile))
        throw core::InvalidInput("--write-profile", file.string(), "a file other than --profile, which is not changed");
    if (std::error_code ignored; fs::exists(file, ignored)) core::require_new_file(file, force);
    gap_case_ = case_of_rig(case_folder, profile_, "--write-profile");
}

RedesignStep::Output RedesignStep::write(const diagnosis::Diagnosis& found, const fs::path& folder) const {
    const search::redesign::Redesign planned = search::redesign::plan_redesign(profile_, toml_, gap_case_, found, {.file = file_});
    search::redesign::write_profiles(planned, force_);
    const std::string json = report::redesign_json(planned);
    core::write_file(folder / "redesign.json", json);
    return {report::redesign_text(planned), json};
}

RigJoint rig_joint(const fs::path& profile, const fs::path& case_folder) {
    if (profile.empty()) return {};
    const profile::Profile rig = profile::read_profile(profile);
    (void)case_of_rig(case_folder, rig, "--profile");
    auto made = made_parts(rig);
    if (!made) return {std::nullopt, "the profile's parts are refused: fusee make " + profile.string() + " says why"};
    return {std::move(made).value().report, ""};
}

std::optional<RedesignStep> redesign_step(const fs::path& profile, const fs::path& file, const fs::path& case_folder, bool force) {
    if (file.empty()) return std::nullopt;
    if (profile.empty()) throw core::InvalidInput("--profile", "missing", "the profile of the rig, together with --write-profile");
    return RedesignStep(profile, file, case_folder, force);
}

}  // namespace fusee::app
