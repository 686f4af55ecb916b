#pragma once
#include <filesystem>
#include <string>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/gap_case/case.h"
#include "fusee/profile/profile.h"
#include "fusee/report/redesign.h"

namespace fusee::pipeline {

/// A profile and a case of the same rig: radii, friction and rates of the base springs, and the springs' torques, as a case built from the
/// profile would have them, each within `kSameRig` build tolerances of the case.
/// @throws core::InvalidInput naming the profile's key, with both figures
void require_same_rig(const profile::Profile& profile, const gap_case::Case& bench);
inline constexpr double kSameRig = 4.0;

struct RedesignOptions {
    std::filesystem::path file;  ///< of the corrected profile; a second one, for the antagonist, gets "-antagonist" before its extension
    int levels = 9;              ///< of co-contraction, from least to overdrive torque; at least 2
};

/// Cams for the rig as it is. The figures of the profile that the effects change become the measured ones (docs/guides/close-the-loop.md):
/// friction of the gears (mean of both sides, since both share one law), rate and preload of each base spring, arms, cable. Under more
/// friction the law (k, u, C) gets a lower C, until the dead-band as read is the one promised or the cams can no longer be cut. Where the
/// sides' springs differ, each side gets a profile of its own. A build parameter inside its tolerance counts only beside an effect on
/// the same figure. Computes, writes nothing.
/// @param toml the text that `profile` was read from
/// @throws core::InvalidInput as require_same_rig; if the law of `profile` itself is refused; naming the key of a measured figure that no
/// profile can hold (a spring that starts slack)
[[nodiscard]] report::Redesign redesign(const profile::Profile& profile, const std::string& toml, const gap_case::Case& bench,
                                        const diagnosis::Diagnosis& found, const RedesignOptions& options);

/// Writes each corrected profile, its folder made if there is none, and `folder`/redesign.json.
/// @throws core::IoError, before anything is written, if a profile stands there already and `force` is not set
void write_redesign(const report::Redesign& redesign, const std::filesystem::path& folder, bool force = false);

}  // namespace fusee::pipeline
