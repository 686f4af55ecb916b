#pragma once
#include <filesystem>
#include <optional>
#include <span>

#include "fusee/actuator/joint.h"
#include "fusee/design/algorithm_1.h"
#include "fusee/pipeline/design.h"
#include "fusee/profile/profile.h"
#include "fusee/search/design_report.h"

namespace fusee::search::codesign {

/// Algorithm 1 for one profile, and its results: a profile, springs compared with the profile's own, cams.
class Judge {
public:
    /// @throws InvalidInput naming the key: friction that is not in proportion to the load, another arrangement, a wanted travel that
    /// would come from a law that cannot be made
    explicit Judge(const profile::Profile& profile);

    [[nodiscard]] const design::Algorithm1& algorithm() const { return *algorithm_; }
    /// The profile with the law found, to be written into `folder`.
    [[nodiscard]] profile::Profile best(std::span<const double> found, const std::filesystem::path& folder) const;
    /// Variables, figures, curves, cams and remarks. @param best as above
    [[nodiscard]] SearchReport report(std::span<const double> found, const profile::Profile& best) const;

private:
    void compare(SearchReport& report, std::span<const double> found) const;
    void judge(SearchReport& report, const profile::Profile& best) const;
    void remark(SearchReport& report, std::span<const double> found) const;

    const profile::Profile& profile_;
    std::optional<pipeline::ResolvedDesign> own_;  ///< none: the profile's law cannot be made
    std::optional<design::Algorithm1> algorithm_;
};

}  // namespace fusee::search::codesign
