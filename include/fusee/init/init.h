#pragma once
#include <functional>
#include <optional>
#include <string>

#include "fusee/core/finding.h"
#include "fusee/init/answers.h"
#include "fusee/profile/profile.h"

namespace fusee::init {

struct Options {
    unsigned jobs = 0;  ///< threads; 0: one per processor; no influence on the result
    /// Called with the share of the work done, 0 to 1, and the present step; may be empty.
    std::function<void(double share, const std::string& step)> progress = {};
    std::function<bool()> stop = {};  ///< asked often; may be empty
};

/// A design for `answers`: the shipped pnrvsa scaled to them, then co-designed, with springs that can be wound.
struct Design {
    profile::Profile profile;
    core::Findings findings;  ///< of every rule, solids included: no error; no rule of springs, cable or material is open
};

/// The nearest joint that can be made, if the wanted one cannot.
struct NearestChange {
    core::Change answer;  ///< {"--cable", "fibre 1", "fibre 0.8"}
    std::string options;  ///< all options of the joint that can be made, for a command line
};

struct Result {
    std::optional<Design> design;
    core::Findings binding;                ///< without a design: the limits that the best candidate breaks, the worst first
    std::optional<NearestChange> nearest;  ///< without a design: the least change of one answer that gives one; none if none was found
    std::size_t judged = 0;                ///< candidates judged
};

/// @param name of the design @throws core::InvalidInput naming the option; core::Stopped when `stop` says so
[[nodiscard]] Result find_design(const std::string& name, const Answers& answers, const Options& options);

/// The commented profile of a design: every key that differs from its default, with the meaning from the schema of keys.
[[nodiscard]] std::string profile_text(const Design& design, const Answers& answers);

}  // namespace fusee::init
