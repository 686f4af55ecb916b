#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/gap_case/case.h"
#include "fusee/pipeline/design_report.h"
#include "fusee/profile/profile.h"

namespace fusee::app {

/// `fusee diagnose --profile PROFILE --write-profile FILE`: from the diagnosis to a profile for the rig as it is.
class RedesignStep {
public:
    /// Reads profile and case; refuses a pair that does not match before the diagnosis begins.
    /// @throws core::InvalidInput, core::IoError
    RedesignStep(const std::filesystem::path& profile, const std::filesystem::path& file, const std::filesystem::path& case_folder,
                 bool force);

    struct Output {
        std::string text;  ///< for the terminal
        std::string json;  ///< redesign.json
    };
    /// Writes the corrected profiles, and redesign.json into `folder`. @throws as search::redesign::plan_redesign and
    /// search::redesign::write_profiles
    [[nodiscard]] Output write(const diagnosis::Diagnosis& found, const std::filesystem::path& folder) const;

private:
    std::filesystem::path file_;
    bool force_;  ///< replaces an existing profile
    std::string toml_;
    profile::Profile profile_;
    gap_case::Case gap_case_;
};

/// The joint of a rig's profile, for the page.
struct RigJoint {
    std::optional<pipeline::DesignReport> design;
    std::string refusal;  ///< why there is none
};
/// Neither design nor refusal without a profile. Refuses a profile of another rig before the diagnosis begins.
/// @throws core::InvalidInput, core::IoError
[[nodiscard]] RigJoint rig_joint(const std::filesystem::path& profile, const std::filesystem::path& case_folder);

/// None without a file for the corrected profile. @throws core::InvalidInput if it is given without a profile, and as RedesignStep
[[nodiscard]] std::optional<RedesignStep> redesign_step(const std::filesystem::path& profile, const std::filesystem::path& file,
                                                        const std::filesystem::path& case_folder, bool force);

}  // namespace fusee::app
