#pragma once
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fusee/core/finding.h"

/// What a profile needs so that it can be made (docs/guides/fix.md).
namespace fusee::report {

/// One key with its new value, as TOML has them.
struct FixChange {
    std::string key, from, to;
    std::string asks_for;   ///< whose business it is: "the drawing", "another spring", "the law", ...
    core::Finding because;  ///< what stood against the old value
    std::string follows;    ///< the key that it follows, as a breaking load follows the cable's diameter; empty: none
};

/// Two limits that stand against each other: what is done for the one breaks the other.
struct FixConflict {
    core::Finding one, other;
    std::string key, from, to;  ///< the change made for `one`, as TOML
    std::string asks;           ///< the value that `other` asks for then; empty: it asks for another key
};

/// Loads that the law gives up because no cam carries them.
struct LostTorque {
    std::string key;                                                                 ///< "law.start_torque_Nm" or "law.end_torque_Nm"
    double from = 0.0, to = 0.0;                                                     ///< [Nm]
    core::Finding binds;                                                             ///< what a law that reaches farther breaks
    [[nodiscard]] double lost() const { return from < to ? to - from : from - to; }  ///< [Nm]
};

struct Fix {
    enum class End {
        kNothingToDo,  ///< the profile can be made as it is
        kFixed,        ///< it can be made with `changes`
        kCannot,       ///< of all profiles tried the one with `changes` comes nearest; `left` binds
    };
    End end = End::kCannot;
    std::string profile_name;
    std::filesystem::path file;  ///< the new profile's; empty unless it is fixed
    std::string toml;            ///< the new profile; empty unless it is fixed
    std::vector<FixChange> changes;
    std::vector<LostTorque> lost;
    core::Findings left;                 ///< what still has to change, or, if fixed, be reviewed
    std::vector<FixConflict> conflicts;  ///< between what is left and other limits; empty if it is fixed
    std::vector<std::string> unchanged;  ///< "cable.diameter_mm: its breaking load is not stated": changes that were not made, and why
    std::size_t not_judged = 0;          ///< rules that could not be judged of the profile that was made, for want of data
    std::vector<std::string> circles;    ///< changes that brought back what an earlier one had taken away, one sentence each
    int judged = 0, made = 0;            ///< profiles judged without files, and made with all of them
    double peak_torque = 0.0;            ///< [Nm]
    std::optional<double> band_before;   ///< exact dead-band at peak torque, full width at the joint [rad]; none: the law does not exist or
                                         ///< does not reach that far
    std::optional<double> band_after;
};

/// Keys as docs/guides/fix.md gives them.
[[nodiscard]] std::string fix_json(const Fix& fix);
/// Lines for a terminal.
[[nodiscard]] std::string fix_text(const Fix& fix);

}  // namespace fusee::report
