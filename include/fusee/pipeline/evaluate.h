#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fusee/cam/arm.h"
#include "fusee/core/finding.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/headline.h"
#include "fusee/profile/profile.h"
#include "fusee/solid/part.h"

/// The one chain from a profile to its findings: law, cam, outline and rules, solid, files. `make` and `check` run it to its end, a search
/// as deep as its time allows.
///
/// Example:
/// @code
/// const profile::Profile p = profile::read_profile("profiles/pnrvsa.toml");
/// const pipeline::Evaluation seen = pipeline::evaluate(p, pipeline::Depth::kOutline);  // some milliseconds, no mesh
/// for (const pipeline::EvaluatedPart& part : seen.parts)
///     std::cout << cam::to_string(part.kind) << ' ' << part.findings.size() << '\n';
/// if (seen.passed()) (void)pipeline::evaluate(p, pipeline::Depth::kFiles);  // every file, read back
/// @endcode
namespace fusee::pipeline {

/// How far a design is followed; each depth includes those before it.
enum class Depth {
    kLaw,      ///< springs and joint
    kCam,      ///< arms and contours, anchors placed
    kOutline,  ///< bodies without a mesh, and every rule that needs no solid: some milliseconds
    kSolid,    ///< solids, every rule, and the joint of both parts
    kFiles,    ///< every file that the profile asks for, read back
};

/// Both parts of a joint, in the order of the findings.
inline constexpr cam::PartKind kBothParts[] = {cam::PartKind::kSeries, cam::PartKind::kParallel};

/// One part, as far as it was evaluated.
struct EvaluatedPart {
    cam::PartKind kind = cam::PartKind::kSeries;
    std::string name = {};             ///< profile::Profile::name_of
    Depth reached = Depth::kLaw;       ///< the last depth without a refusal of cam, body or solid; deeper rules have not judged the part
    std::optional<cam::Cam> cam = {};  ///< from kCam on
    std::optional<solid::Part> body =
        {};                        ///< from kOutline on, earlier where the anchor's place asked for it; with its mesh from kSolid on
    core::Findings findings = {};  ///< of the rules run, passes too, or the refusal
};

/// What is known of a design at a depth. Rules that lack data are findings of severity kNotJudged; rules behind a refusal have not been
/// run: `reached` says so.
struct Evaluation {
    std::optional<ResolvedDesign> design = {};  ///< none: no law
    core::Findings findings = {};               ///< of the law and of the design as a whole
    std::vector<EvaluatedPart> parts = {};      ///< those asked for; none without a law. From kFiles on the findings of each side, no body
    FileErrors file_errors = {};                ///< of kFiles

    /// All findings: those of the design, then those of each part.
    [[nodiscard]] core::Findings all() const;
    [[nodiscard]] bool passed() const { return !core::any_error(all()); }
};

/// Evaluates one part of a resolved design. @pre require_parts(design.profile); depth below kFiles @throws core::InvalidInput naming the
/// key
[[nodiscard]] EvaluatedPart evaluate_part(cam::PartKind kind, const ResolvedDesign& design, Depth depth);
/// Takes a part deeper, from the cam that it has; a refused part is refused again.
void deepen(EvaluatedPart& part, const ResolvedDesign& design, Depth depth);

/// The solid of an evaluated part. Refusal: its findings, if one is an error or if it is not that deep.
[[nodiscard]] core::Outcome<DesignedPart> designed(EvaluatedPart part);

/// Evaluates a profile: each part on its own thread, one result for any number of threads.
/// @param kinds the parts to evaluate up to kSolid, none: all that the profile describes; kFiles makes all
/// @throws core::InvalidInput naming the key; core::IoError from kFiles on, which writes into a temporary folder
[[nodiscard]] Evaluation evaluate(const profile::Profile& profile, Depth depth, std::span<const cam::PartKind> kinds = {});
/// The same of a design that is resolved already. @pre depth below kFiles
[[nodiscard]] Evaluation evaluate(ResolvedDesign design, Depth depth, std::span<const cam::PartKind> kinds = {});

}  // namespace fusee::pipeline
