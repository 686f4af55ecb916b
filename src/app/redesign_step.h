#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "fusee/diagnosis/diagnosis.h"
#include "fusee/report/diagnosis.h"

/// What a diagnosis takes from the profile of the rig. A program without designs starts the whole one instead (program.h).
namespace fusee::app {

struct Redesigned {
    std::string text;  ///< for the terminal
    std::string json;  ///< redesign.json
};
/// `fusee diagnose --profile PROFILE --write-profile FILE`, from the diagnosis to a profile for the rig as it is: writes the corrected
/// profiles, and redesign.json into `folder`. @throws as search::redesign::plan_redesign and write_profiles
using RedesignStep = std::function<Redesigned(const diagnosis::Diagnosis& found, const std::filesystem::path& folder)>;

/// Empty without a file for the corrected profile. Reads profile and case; refuses a pair that does not match before the diagnosis begins.
/// @param force replaces an existing profile. @throws core::InvalidInput, also if the file is given without a profile; core::IoError
[[nodiscard]] RedesignStep redesign_step(const std::filesystem::path& profile, const std::filesystem::path& file,
                                         const std::filesystem::path& case_folder, bool force);

/// The joint of a rig's profile, for the page.
struct RigJoint {
    std::optional<report::JointScene> scene;  ///< none without a profile, or with a refusal
    std::string refusal;                      ///< why there is none
};
/// Refuses a profile of another rig before the diagnosis begins. @throws core::InvalidInput, core::IoError
[[nodiscard]] RigJoint rig_joint(const std::filesystem::path& profile, const std::filesystem::path& case_folder);

}  // namespace fusee::app
