#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "figures.h"
#include "fusee/actuator/joint.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/edit.h"
#include "fusee/profile/profile.h"
#include "fusee/search/redesign.h"
#include "fusee/spring/law.h"

/// Corrected profiles from a diagnosis, and cams of one profile on a rig with other figures.
namespace fusee::search::redesign {

/// A corrected profile while it is made.
struct Draft {
    CorrectedProfile report;
    profile::Profile profile;
    spring::SpringLawPtr law;  ///< none: refused
    [[nodiscard]] bool is_for(int side) const;
};
[[nodiscard]] bool can_be_cut(const std::vector<Draft>& drafts);

/// Writes drafts for the figures that a diagnosis changes. Keeps references to its arguments.
class Drafter {
public:
    Drafter(const pipeline::ResolvedDesign& original, const std::string& toml, const gap_case::Case& gap_case,
            const diagnosis::Diagnosis& found, const std::filesystem::path& file);

    /// The profile with the measured figures of each side of the rig.
    [[nodiscard]] const std::array<profile::Profile, 2>& as_is() const { return as_is_; }
    [[nodiscard]] bool changes_anything() const { return !own_[0].empty() || !own_[1].empty() || !shared_.empty(); }
    /// A side needs new cams if its springs differ or if the law depends on the friction.
    [[nodiscard]] bool needs_cams(int side) const;
    /// Can C be chosen for the measured friction?
    [[nodiscard]] bool has_choice() const { return !law_edits(1.0).empty(); }
    /// One for both sides; one for each where they differ; one for the only side that needs new cams.
    /// @param share of the way to C ~ 1/mu, which keeps the transmitted stiction T tau_f = mu C + u^2/tau; 0: C stays
    /// @throws core::InvalidInput naming the key of a figure that no profile can hold
    [[nodiscard]] std::vector<Draft> drafts(double share) const;

private:
    using Edits = std::vector<profile::Edit>;
    [[nodiscard]] bool friction_departs() const;
    [[nodiscard]] Edits spring_edits(int side) const;
    [[nodiscard]] Edits shared_edits() const;
    [[nodiscard]] Edits law_edits(double share) const;
    [[nodiscard]] Draft draft(const std::string& sides, const Edits& own, double share, bool of_two) const;
    [[nodiscard]] std::string head(const std::string& sides) const;

    const profile::Profile& profile_;
    const std::string& toml_;
    const gap_case::Case& gap_case_;
    const std::filesystem::path& file_;
    std::vector<Departure> departures_;
    std::array<profile::Profile, 2> as_is_;
    std::array<Edits, 2> own_;
    Edits shared_;
};

/// Cams, the profile that they were cut for, and its law.
struct Cams {
    const profile::Profile* profile = nullptr;
    spring::SpringLawPtr law;
};
/// The spring that the spool or cam of `cams` makes of the base spring, cable and arms of `as_is` (docs/theory/springs.md, eq. 24 to 28).
[[nodiscard]] spring::PotentialPtr series_as_built(const Cams& cams, const profile::Profile& as_is);
[[nodiscard]] spring::PotentialPtr parallel_as_built(const Cams& cams, const profile::Profile& as_is);

/// The joint with those cams on each side, and with the friction and bearing of `as_is`.
[[nodiscard]] actuator::Joint joint_as_built(const std::array<Cams, 2>& cams, const std::array<profile::Profile, 2>& as_is);

/// Greatest |torque as built - law|/law of the four springs, over the deflections that both reach.
[[nodiscard]] double torque_error(const std::array<Cams, 2>& cams, const std::array<profile::Profile, 2>& as_is);

[[nodiscard]] DeadBandWidths dead_band_widths(const actuator::Joint& joint, double tau, double push_torque);

}  // namespace fusee::search::redesign
