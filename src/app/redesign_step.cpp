#include "redesign_step.h"

#include <system_error>
#include <utility>

#include "fusee/report/search.h"
#include "fusee/search/redesign.h"
#include "made_parts.h"
#include "places.h"

namespace fusee::app {

namespace {

/// @param option the one that a case without a joint makes useless. @throws core::InvalidInput if case and profile are not of one rig
gap_case::Case case_of_rig(const fs::path& folder, const profile::Profile& profile, const char* option) {
    if (gap_case::kind_of_case(folder) != gap_case::CaseKind::kJoint)
        throw core::InvalidInput(option, folder.string(), "a case with [rig]: this one is no whole joint");
    gap_case::Case gap_case = gap_case::read_case(folder);
    with_places(profile, [&] { (void)search::redesign::require_same_rig(profile, gap_case); });
    return gap_case;
}

}  // namespace

RedesignStep redesign_step(const fs::path& profile, const fs::path& file, const fs::path& case_folder, bool force) {
    if (file.empty()) return {};
    if (profile.empty()) throw core::InvalidInput("--profile", "missing", "the profile of the rig, together with --write-profile");
    const std::string toml = core::read_file(profile, profile::kLargestFile);
    const profile::Profile rig = profile::parse_profile(toml, profile);
    if (fs::weakly_canonical(file) == fs::weakly_canonical(profile))
        throw core::InvalidInput("--write-profile", file.string(), "a file other than --profile, which is not changed");
    if (std::error_code ignored; fs::exists(file, ignored)) core::require_new_file(file, force);
    const gap_case::Case measured = case_of_rig(case_folder, rig, "--write-profile");
    return [=](const diagnosis::Diagnosis& found, const fs::path& folder) {
        const search::redesign::Redesign planned = search::redesign::plan_redesign(rig, toml, measured, found, {.file = file});
        search::redesign::write_profiles(planned, force);
        const std::string json = report::redesign_json(planned);
        core::write_file(folder / "redesign.json", json);
        return Redesigned{report::redesign_text(planned), json};
    };
}

RigJoint rig_joint(const fs::path& profile, const fs::path& case_folder) {
    if (profile.empty()) return {};
    const profile::Profile rig = profile::read_profile(profile);
    (void)case_of_rig(case_folder, rig, "--profile");
    auto made = made_parts(rig);
    if (!made) return {{}, "the profile's parts are refused: fusee make " + profile.string() + " says why"};
    const pipeline::DesignReport design = std::move(made).value().report;
    if (!design.assembly) return {};
    return {report::joint_scene(design), ""};
}

}  // namespace fusee::app
