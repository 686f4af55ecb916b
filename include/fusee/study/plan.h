#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "fusee/profile/profile.h"
#include "fusee/study/study.h"

namespace fusee::study {

/// One design of a study before it is made.
struct Planned {
    std::size_t index = 0;
    std::string name;                 ///< of the design and its folder, e.g. "pnrvsa-diameter_mm-0.8"
    std::vector<std::string> values;  ///< of the keys that vary, as TOML, in the order of Study::vary
    std::string excluded_by;          ///< the constraint that excludes it; empty: none
};

/// The designs of a study, each computed from its index alone, so that a million of them take no memory. Immutable; thread-safe.
class Plan {
public:
    /// @throws core::IoError; core::InvalidInput naming the study's key: one that the base profile does not have, a constraint that is no
    /// formula
    explicit Plan(Study study);
    ~Plan();

    [[nodiscard]] const Study& study() const;
    [[nodiscard]] std::size_t size() const;
    /// @pre index < size()
    [[nodiscard]] Planned at(std::size_t index) const;
    /// SHA-256 of all that the study's files say of the design: the profile, the CSV files that it names, the keys that vary with their
    /// values. @throws as profile()
    [[nodiscard]] std::string digest(const Planned& planned) const;
    /// The design's profile: the base with its values, or the file of the list. @throws as profile::read_profile; a mistake in a value that
    /// varies names the study's key
    [[nodiscard]] profile::Profile profile(const Planned& planned) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fusee::study
