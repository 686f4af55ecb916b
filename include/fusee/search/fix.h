#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/profile/profile.h"

/// The changes that a profile needs so that it can be made (docs/guides/fix.md).
namespace fusee::search::fix {

/// A change of the result, with its reason.
struct MadeChange : core::Change {
    std::string asks_for;   ///< what the change concerns: "the drawing", "another spring", "the law", ...
    core::Finding because;  ///< the finding against the old value
    std::string follows;    ///< the key that it follows, as a breaking load follows the cable's diameter; empty: none
};

/// Two limits that conflict: a change for the one breaks the other.
struct Conflict {
    core::Finding one, other;
    core::Change change;  ///< made for `one`
    std::string asks;     ///< the value that `other` then suggests; empty: it suggests another key
};

/// Loads that the law loses because no cam carries them.
struct LostTorque {
    std::string key;                                                                 ///< "law.start_torque_Nm" or "law.end_torque_Nm"
    double from = 0.0, to = 0.0;                                                     ///< [Nm]
    core::Finding binds;                                                             ///< the limit that a law with a wider range breaks
    [[nodiscard]] double lost() const { return from < to ? to - from : from - to; }  ///< [Nm]
};

/// The changes that a profile needs so that it can be made.
struct Fix {
    enum class End {
        kNothingToDo,  ///< the profile can be made as it is
        kFixed,        ///< it can be made with `changes`, over the whole range of its law
        kShortened,    ///< it can be made with `changes`, which give up the loads `lost`
        kCannot,       ///< of all candidates the one with `changes` is nearest; `left` binds
    };
    End end = End::kCannot;
    std::string profile_name;
    std::filesystem::path file;  ///< the new profile's; empty unless it can be made
    std::string toml;            ///< the new profile; empty unless it can be made
    std::vector<MadeChange> changes;
    std::vector<LostTorque> lost;
    core::Findings left;                 ///< findings that remain: errors, or, if fixed, warnings
    std::vector<Conflict> conflicts;     ///< between the findings left and other limits; empty if it is fixed
    std::vector<std::string> unchanged;  ///< "cable.diameter_mm: its breaking load is not stated": changes that were not made, and why
    std::string ended;                   ///< why the search ended before it had tried every change; empty: it has
    std::size_t not_judged = 0;          ///< rules of the profile made that were not judged, because data are missing
    std::vector<std::string> circles;    ///< changes that broke again what an earlier change had cured, one sentence each
    int judged = 0, made = 0;            ///< profiles judged without files, and made with all of them
    double peak_torque = 0.0;            ///< [Nm]
    std::optional<double> band_before;   ///< exact dead-band at peak torque, full width at the joint [rad]; none: the law does not exist or
                                         ///< does not reach that far
    std::optional<double> band_after;
};

struct FixOptions {
    std::filesystem::path file;          ///< of the new profile: the tables that it names are reached from its folder
    bool reviews = false;                ///< cure warnings, too
    std::vector<std::string> keep = {};  ///< keys, or tables, that are not changed
    int most_judged = 1000;              ///< profiles judged before the search gives up
    int most_made = 20;                  ///< profiles made, likewise
    unsigned jobs = 0;                   ///< threads; 0: one per processor. The result does not depend on it
    /// Findings when a draft is made; empty: makes every file in a temporary folder and reads it back.
    std::function<core::Findings(const profile::Profile&)> make = {};
    std::function<void(const std::string&)> progress = {};  ///< called with each step that brings the search nearer; may be empty
    std::function<bool()> stop = {};                        ///< asked before each profile is judged; may be empty
};

/// Applies the changes that the findings suggest, best first, until the profile can be made with all its files (docs/guides/fix.md): drawn
/// features before bought parts, the law last. No single change of the result can be left out, and law and base springs stay as near to
/// the old ones as the limits allow. Facts (rig, machine, strength of a material) are never changed; bought parts come in standard sizes,
/// and no part of unknown strength is weakened. Writes into temporary folders only.
/// @param toml the text that `profile` was read from
/// @throws core::InvalidInput as `make`, and naming --keep with the nearest key if a key does not exist; core::Stopped when `stop` says so
[[nodiscard]] Fix find_fix(const profile::Profile& profile, const std::string& toml, const FixOptions& options);

}  // namespace fusee::search::fix
