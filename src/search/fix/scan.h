#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "draft.h"
#include "judge.h"

namespace fusee::search::fix {

/// If law and cams do not fit each other, one suggested number is seldom enough: a cure at one end breaks the other end. A scan judges
/// values in steps from those of the draft, nearest first, once for the same law and cams.
class Scan {
public:
    Scan(const Drafts& drafts, Judge& judge, unsigned jobs) : drafts_(drafts), judge_(judge), jobs_(jobs) {}

    /// A step, and the number of findings left after it.
    struct Step {
        core::Changes changes;
        Follows follows;
        int left = 0;
    };
    /// Another preload, another rate, and, if neither alone cures everything, both. `left` counts the part alone.
    [[nodiscard]] const std::vector<Step>& springs(cam::PartKind part, const profile::Profile& draft, const Choices& choices);
    /// An earlier end, a later start, a shorter lead-in.
    [[nodiscard]] const std::vector<Step>& laws(const profile::Profile& draft, const Choices& choices);

private:
    [[nodiscard]] std::vector<Step> scan_springs(cam::PartKind part, const profile::Profile& draft, const Choices& choices);
    [[nodiscard]] std::vector<Step> scan_laws(const profile::Profile& draft, const Choices& choices);

    using Look = std::function<Verdict(const profile::Profile&)>;
    /// Adds the nearest step after which law and cams are sound, and the nearest with the fewest findings; the same one once.
    /// @returns whether a step leaves no finding
    bool walk(const std::vector<core::Changes>& steps, const Choices& choices, const Look& look, std::vector<Step>& found) const;

    const Drafts& drafts_;
    Judge& judge_;
    unsigned jobs_;
    std::map<std::string, std::vector<Step>> known_;
};

}  // namespace fusee::search::fix
