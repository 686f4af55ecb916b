#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/diagnosis/diagnosis.h"
#include "fusee/gap_case/case.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/edit.h"
#include "fusee/profile/profile.h"

/// The consequences of a diagnosis for the cams: corrected profiles, and the dead-band with the old and the new cams
/// (docs/guides/close-the-loop.md).
namespace fusee::search::redesign {

/// The co-contractions at which the springs reach every resting place that stiction allows, of those that the profile asks for.
struct Cover {
    core::Range asked{0.0, 0.0};                                         ///< least to overdrive torque [Nm]
    core::Range covered{diagnosis::kNoFigure, diagnosis::kNoFigure};     ///< NaN: none [Nm]
    core::Range law_loads{diagnosis::kNoFigure, diagnosis::kNoFigure};   ///< of a capstan, of the springs' law [Nm]
    core::Range rest_loads{diagnosis::kNoFigure, diagnosis::kNoFigure};  ///< at which friction lets it rest over the torques asked for [Nm]
    [[nodiscard]] bool whole() const { return covered.low <= asked.low && covered.high >= asked.high; }
};
/// A corrected profile.
struct CorrectedProfile {
    std::string sides;           ///< whose cams it cuts: "both", "agonist", "antagonist"
    std::filesystem::path file;  ///< where it is to be written
    std::string toml;
    std::vector<profile::Edit> changes;
    core::Findings findings;  ///< as `fusee make` will report them, without passes
    Cover cover;
    [[nodiscard]] bool can_be_cut() const { return !core::any_error(findings); }
};
/// Full widths at the joint [rad]; NaN: the springs do not reach.
struct DeadBandWidths {
    double exact_width = diagnosis::kNoFigure;     ///< between the outermost resting places
    double measured_width = diagnosis::kNoFigure;  ///< by a push-and-release test
};
struct Level {
    double tau = 0.0;         ///< co-contraction [Nm]
    DeadBandWidths promised;  ///< by the old profile
    DeadBandWidths old_cams;  ///< the rig as it is
    DeadBandWidths new_cams;  ///< the same rig with cams of the corrected profile
};
/// An effect that no cam can compensate.
struct NotMended {
    effects::Cause cause;
    std::string instead;  ///< the advice, one sentence
};

/// The consequences of a diagnosis for the cams.
struct Redesign {
    std::string profile_name, case_name, case_sha256;
    bool new_cams_needed = false;  ///< false: no effect was found that a cam can compensate
    std::vector<CorrectedProfile>
        profiles;               ///< one, or one for each side where they differ; none: no effect was found that a profile can hold
    double push_torque = 0.0;   ///< of the push-and-release test, at the joint [Nm]; 0: as strong as needed
    std::vector<Level> levels;  ///< by rising co-contraction
    Level peak;                 ///< at peak torque, where `fusee make` gives the exact width; with levels
    /// Greatest difference between a spring's torque on the rig as it is and the law its cam was cut for, over that torque.
    double torque_error_old = diagnosis::kNoFigure, torque_error_new = diagnosis::kNoFigure;
    std::vector<NotMended> not_mended;
    std::vector<std::string> remarks;

    /// Mean over the levels of |measured width - promised| over the promised; NaN where no level is known.
    [[nodiscard]] double off_with_old_cams() const;
    [[nodiscard]] double off_with_new_cams() const;
};

/// A profile and a case of the same rig: radii, friction and rates of the base springs, and the springs' torques, as a case built from the
/// profile would have them, each within `kSameRig` build tolerances of the case.
/// @return the profile, resolved @throws core::InvalidInput naming the profile's key, with both figures
pipeline::ResolvedDesign require_same_rig(const profile::Profile& profile, const gap_case::Case& gap_case);
inline constexpr double kSameRig = 4.0;

struct RedesignOptions {
    std::filesystem::path file;  ///< of the corrected profile; a second one, for the antagonist, gets "-antagonist" before its extension
    int levels = 9;              ///< of co-contraction, from least to overdrive torque; at least 2
};

/// Cams for the rig as it is. The figures of the profile that the effects change become the measured ones (docs/guides/close-the-loop.md):
/// friction of the gears (mean of both sides, since both share one law), rate and preload of each base spring, arms, cable. Under more
/// friction the law (k, u, C) gets a lower C, until the measured dead-band is the promised one or the cams can no longer be cut. Where the
/// sides' springs differ, each side gets its own profile. A build parameter inside its tolerance counts only together with an effect
/// on the same figure. Writes nothing.
/// @param toml the text that `profile` was read from
/// @throws core::InvalidInput as require_same_rig; if the law of `profile` itself is refused; naming the key of a measured figure that no
/// profile can hold (a spring that starts slack)
[[nodiscard]] Redesign plan_redesign(const profile::Profile& profile, const std::string& toml, const gap_case::Case& gap_case,
                                     const diagnosis::Diagnosis& found, const RedesignOptions& options);

/// The keys of a profile whose figures an effect of usual size changes on a rig, in the order of a redesign; empty: no profile value
/// represents it. @throws core::InvalidInput if the effect is unknown
[[nodiscard]] std::vector<std::string> keys_of_effect(const std::string& effect_id);

/// Writes each corrected profile, its folder made if there is none.
/// @throws core::IoError, before anything is written, if the file exists and `force` is not set
void write_profiles(const Redesign& redesign, bool force = false);

}  // namespace fusee::search::redesign
