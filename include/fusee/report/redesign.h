#pragma once
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/diagnosis/diagnosis.h"

/// What a diagnosis means for the cams: corrected profiles, and the dead-band with the old cams and with new ones
/// (docs/guides/close-the-loop.md).
namespace fusee::report {

/// One value of a profile, as its file writes it.
struct RedesignChange {
    std::string key, was, is, why;
};
/// The co-contractions at which the springs reach every resting place that stiction allows, of those that the profile asks for.
struct RedesignCover {
    core::Range asked{0.0, 0.0};                                         ///< least to overdrive torque [Nm]
    core::Range covered{diagnosis::kNoFigure, diagnosis::kNoFigure};     ///< NaN: none [Nm]
    core::Range law_loads{diagnosis::kNoFigure, diagnosis::kNoFigure};   ///< of a capstan, that the springs' law has [Nm]
    core::Range rest_loads{diagnosis::kNoFigure, diagnosis::kNoFigure};  ///< at which friction lets it rest over the torques asked for [Nm]
    [[nodiscard]] bool whole() const { return covered.low <= asked.low && covered.high >= asked.high; }
};
/// A corrected profile.
struct RedesignProfile {
    std::string sides;           ///< whose cams it cuts: "both", "agonist", "antagonist"
    std::filesystem::path file;  ///< where it is to be written
    std::string toml;
    std::vector<RedesignChange> changes;
    core::Findings findings;  ///< what `fusee make` is going to say of it, passes left out
    RedesignCover cover;
    [[nodiscard]] bool can_be_cut() const { return !core::any_error(findings); }
};
/// Full widths at the joint [rad]; NaN: the springs do not reach.
struct DeadBandWidths {
    double exact_width = diagnosis::kNoFigure;     ///< between the outermost resting places
    double measured_width = diagnosis::kNoFigure;  ///< by a push-and-release test
};
struct RedesignLevel {
    double tau = 0.0;         ///< co-contraction [Nm]
    DeadBandWidths promised;  ///< by the old profile
    DeadBandWidths old_cams;  ///< the rig as it is
    DeadBandWidths new_cams;  ///< the same rig with cams of the corrected profile
};
/// An effect that no cam makes up for.
struct NotMended {
    effects::Cause cause;
    std::string instead;  ///< what to do, one sentence
};

struct Redesign {
    std::string profile_name, case_name, case_sha256;
    bool new_cams_needed = false;  ///< false: nothing was found that a cam makes up for
    std::vector<RedesignProfile>
        profiles;                       ///< one, or one for each side where they differ; none: nothing was found that a profile can hold
    double push_torque = 0.0;           ///< of the push-and-release test, at the joint [Nm]; 0: strong enough
    std::vector<RedesignLevel> levels;  ///< by rising co-contraction
    RedesignLevel peak;                 ///< at peak torque, where `fusee make` gives the exact width; with levels
    /// Greatest difference between a spring's torque on the rig as it is and the law its cam was cut for, over that torque.
    double torque_error_old = diagnosis::kNoFigure, torque_error_new = diagnosis::kNoFigure;
    std::vector<NotMended> not_mended;
    std::vector<std::string> remarks;

    /// Mean over the levels of |width as read - promised| over the promised; NaN where no level is known.
    [[nodiscard]] double off_with_old_cams() const;
    [[nodiscard]] double off_with_new_cams() const;
};

/// Keys as docs/guides/close-the-loop.md gives them; a NaN is null.
[[nodiscard]] std::string redesign_json(const Redesign& redesign);
/// A section for the page of the diagnosis.
[[nodiscard]] std::string redesign_section(const Redesign& redesign);
/// A few lines for a terminal.
[[nodiscard]] std::string redesign_text(const Redesign& redesign);

}  // namespace fusee::report
