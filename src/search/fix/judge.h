#pragma once
#include <optional>
#include <span>
#include <string>

#include "fusee/cam/arm.h"
#include "fusee/core/error.h"
#include "fusee/core/finding.h"
#include "fusee/search/fix.h"

namespace fusee::search::fix {

// The number of findings that a refusal is estimated to hide: large enough that a draft which comes farther is preferred.
inline constexpr int kBehindBody = 1, kBehindCam = 2, kBehindLaw = 6;

/// The findings against a profile, as far as they could be seen.
struct Verdict {
    core::Findings broken;
    int unseen = 0;  ///< findings that a refusal may hide: without a law all of both cams, without a cam all of its body
    [[nodiscard]] bool clear() const { return broken.empty(); }
    [[nodiscard]] int left() const { return static_cast<int>(broken.size()) + unseen; }
    /// Errors among them, and the hidden ones.
    [[nodiscard]] int errors() const { return static_cast<int>(core::count(broken, core::Severity::kError)) + unseen; }
};

/// "cam.arm k_pe": rule and part.
[[nodiscard]] std::string name_of(const core::Finding& finding);
/// The part that a key or a place begins with: "k_se", "k_pe", or "cam" of a single spring; empty for none.
[[nodiscard]] std::string part_of(const std::string& text);
[[nodiscard]] std::string part_of(const core::Finding& finding);
/// The kind of that part in the profile.
[[nodiscard]] cam::PartKind kind_of(const std::string& part, const profile::Profile& profile);

/// Those of at least this severity.
[[nodiscard]] core::Findings broken_in(const core::Findings& findings, core::Severity least);

/// The result of `work`; none if the values of a draft are not allowed or inconsistent: the search skips such a draft.
template <class Work>
auto if_allowed(const Work& work) -> std::optional<decltype(work())> {
    try {
        return work();
    } catch (const core::InvalidInput&) {
        return std::nullopt;
    } catch (const core::InvalidInputs&) {
        return std::nullopt;
    }
}

/// Judges profiles, cheapest step first. Counts its work and asks whether to stop.
class Judge {
public:
    explicit Judge(const FixOptions& options) : options_(options) {}

    /// Law, cams, bodies and every rule that needs no mesh: some milliseconds. @throws core::Stopped
    [[nodiscard]] Verdict drawing(const profile::Profile& profile);
    /// The same, not counted, of some parts alone and their law. Thread-safe. @param kinds empty: all
    [[nodiscard]] Verdict seen(const profile::Profile& profile, std::span<const cam::PartKind> kinds = {}) const;
    /// One more profile was seen, and its verdict needed.
    void count() { ++judged_; }
    /// The expensive part: solids with every rule, then, of what is clear, all files, read back. @throws core::Stopped
    [[nodiscard]] Verdict making(const profile::Profile& profile);
    /// Drawing, then solids: all but what only files show.
    [[nodiscard]] Verdict unwritten(const profile::Profile& profile);
    [[nodiscard]] Verdict all(const profile::Profile& profile);

    [[nodiscard]] int judged() const { return judged_; }
    [[nodiscard]] int made() const { return made_; }
    /// Warnings of the last profile that was made and was clear.
    [[nodiscard]] const core::Findings& warnings() const { return warnings_; }
    /// Rules of that profile that were not judged.
    [[nodiscard]] std::size_t not_judged() const { return not_judged_; }

private:
    [[nodiscard]] Verdict solids(const profile::Profile& profile);
    void keep(Verdict& verdict, const core::Findings& findings) const;
    void ask_to_stop() const;

    const FixOptions& options_;
    int judged_ = 0, made_ = 0;
    core::Findings warnings_;
    std::size_t not_judged_ = 0;
};

}  // namespace fusee::search::fix
