#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "fusee/mjcf/twin.h"

namespace fusee::mjcf {

inline constexpr const char* kModelFile = "joint.xml";
inline constexpr const char* kLawsFile = "laws.json";
inline constexpr const char* kJavaScriptFile = "joint_twin.mjs";
inline constexpr const char* kPythonFile = "joint_twin.py";

/// The model for MuJoCo 3.6 and later: what the engine holds without help, with the error of each spring in a comment.
[[nodiscard]] std::string model_xml(const Twin& twin);
/// The exact laws, which both companion programs read.
[[nodiscard]] std::string laws_json(const Twin& twin);
/// The companion programs, the same for every joint.
[[nodiscard]] std::string_view companion_javascript();
[[nodiscard]] std::string_view companion_python();

/// Writes all four files into an existing folder. @throws core::IoError
void write(const Twin& twin, const std::filesystem::path& folder);

}  // namespace fusee::mjcf
