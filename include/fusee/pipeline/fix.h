#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fusee/profile/profile.h"
#include "fusee/report/fix.h"

namespace fusee::pipeline {

struct FixOptions {
    std::filesystem::path file;          ///< of the new profile: the tables that it names are reached from its folder
    bool reviews = false;                ///< take away what findings ask to review, too
    std::vector<std::string> keep = {};  ///< keys, or tables, that are not changed
    int most_judged = 1000;              ///< profiles judged before the search gives up
    int most_made = 20;                  ///< profiles made, likewise
    /// What is found when a draft is made in the end; empty: every file, in a folder that passes, and read back.
    std::function<core::Findings(const profile::Profile&)> make = {};
    std::function<void(const std::string&)> progress = {};  ///< told of each step that brings the search nearer; may be empty
    std::function<bool()> stop = {};                        ///< asked before each profile is judged; may be empty
};

/// Changes what the findings suggest, best first, until the profile can be made with all its files (docs/guides/fix.md): what is drawn
/// before what is bought, and the law last. No single change of the answer can be left out, and law and base springs are as near to what
/// they were as the limits allow. Facts (rig, machine, what a material bears) are never changed; bought parts come
/// in standard sizes, and none is weakened whose strength is not known. Computes and makes in a folder that
/// passes; writes nothing else.
/// @param toml the text that `profile` was read from
/// @throws core::InvalidInput as `make`, and naming --keep with the nearest key for one that is none; core::Stopped when `stop` says so
[[nodiscard]] report::Fix fix(const profile::Profile& profile, const std::string& toml, const FixOptions& options);

}  // namespace fusee::pipeline
