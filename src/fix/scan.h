#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "draft.h"
#include "judge.h"

namespace fusee::fix {

/// Where a finding says that law and cams do not suit each other, one suggested number seldom ends it: what is sound at one end breaks at
/// the other. So values are tried in steps from those of the draft, nearest first; each scan once for the same law and cams.
class Scan {
public:
    Scan(const Drafts& drafts, Judge& judge) : drafts_(drafts), judge_(judge) {}

    /// A step, and what is left to do after it.
    struct Step {
        core::Changes changes;
        Follows follows;
        int left = 0;
    };
    /// Another preload, another rate, and if neither alone leaves nothing broken, both. `left` counts the part alone.
    [[nodiscard]] const std::vector<Step>& springs(cam::PartKind part, const profile::Profile& draft, const Choices& choices);
    /// An earlier end, a later start, a shorter lead-in.
    [[nodiscard]] const std::vector<Step>& laws(const profile::Profile& draft, const Choices& choices);

private:
    [[nodiscard]] std::vector<Step> try_springs(cam::PartKind part, const profile::Profile& draft, const Choices& choices);
    [[nodiscard]] std::vector<Step> try_laws(const profile::Profile& draft, const Choices& choices);

    using Look = std::function<Verdict(const profile::Profile&)>;
    /// Of the steps the nearest that leaves law and cams sound, and the nearest that leaves the least broken; the same one once.
    /// @returns whether one of them leaves nothing broken
    bool walk(const std::vector<core::Changes>& steps, const Choices& choices, const Look& look, std::vector<Step>& found) const;

    const Drafts& drafts_;
    Judge& judge_;
    std::map<std::string, std::vector<Step>> known_;
};

}  // namespace fusee::fix
