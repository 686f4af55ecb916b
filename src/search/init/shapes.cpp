#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "fusee/checks/limits.h"
#include "fusee/design/evolution.h"
#include "fusee/pipeline/design.h"
#include "search.h"

namespace fusee::search::init {

namespace {

using core::mm_from_m;

constexpr int kShapePopulation = 16, kShapeGenerations = 30;
constexpr double kWidestWrap = 2.0 * core::kPi - 0.2;  // of a planar cam: rule cam.wrap
constexpr double kNoContour = 1e3;                     // [m] of a contour that breaks a limit: above every radius

/// Radius of curvature at which rule cable.bend_ratio begins to pass [m].
double sharpest_bend(const Answers& answers) { return 0.5 * (checks::cable_limits(answers.construction).critical + 1.0) * answers.cable; }

/// Contours of one part.
class Contours {
public:
    Contours(cam::PartKind part, const Answers& answers)
        : part_(part),
          answers_(answers),
          variables_(variables_of(answers)),
          start_(start_of(answers)),
          least_rho_(sharpest_bend(answers)) {}

    [[nodiscard]] std::vector<core::Range> bounds() const { return bounds_of(variables_); }
    [[nodiscard]] std::optional<codesign::Shape> shape(std::span<const double> x) const {
        const auto design = pipeline::resolve_for_search(scaled("init", answers_, entered(start_, variables_, x)));
        if (!design) return std::nullopt;
        return codesign::shape_of(design->arm(part_), design->spec(part_).cam);
    }
    /// Radius, or how far a limit is broken.
    [[nodiscard]] double operator()(std::span<const double> x) const {
        const auto s = shape(x);
        if (!s) return 3.0 * kNoContour;
        const double bent = (least_rho_ - s->least_rho) / least_rho_, wound = s->wrap - kWidestWrap;
        if (!(bent <= 0.0) || !(wound <= 0.0))
            return kNoContour *
                   (1.0 + std::clamp(std::isnan(bent) ? 1.0 : bent / (1.0 + std::abs(bent)), 0.0, 1.0) + std::max(wound, 0.0) / 30.0);
        return s->radius;
    }

private:
    cam::PartKind part_;
    const Answers& answers_;
    std::vector<Variable<Scale>> variables_;
    Scale start_;
    double least_rho_;
};

}  // namespace

double broken_share(const codesign::Shape& shape, const Answers& answers, double margin) {
    const double rho = margin * sharpest_bend(answers), bent = (rho - shape.least_rho) / rho;
    const double share = std::isnan(bent) ? 1.0 : std::max(bent, 0.0) / (1.0 + std::max(bent, 0.0));
    return share + std::max(0.0, shape.wrap - kWidestWrap) / 30.0 + 0.1 * std::max(0.0, shape.radius / contour_limit(answers) - 1.0);
}

LeastContour least_contour(cam::PartKind part, const Answers& answers, unsigned jobs) {
    const Contours contours(part, answers);
    design::EvolutionOptions evolution;
    evolution.bounds = contours.bounds();
    evolution.population = kShapePopulation;
    evolution.generations = kShapeGenerations;
    evolution.jobs = jobs;
    const design::EvolutionResult found = design::evolve(std::cref(contours), evolution);
    const auto best = contours.shape(found.best);
    if (!best) return {INFINITY, NAN, NAN};
    return {found.cost < kNoContour ? found.cost : INFINITY, best->least_rho, best->wrap};
}

core::Findings broken_contours(const Answers& answers, unsigned jobs) {
    core::Findings findings;
    for (const cam::PartKind part : {cam::PartKind::kSeries, cam::PartKind::kParallel}) {
        const LeastContour least = least_contour(part, answers, jobs);
        const double most = contour_limit(answers), least_rho = sharpest_bend(answers);
        if (least.radius <= most) continue;
        core::Finding f;
        if (std::isfinite(least.radius))
            f = core::error_finding("limit.contour_radius",
                                    "the smallest contour round which this cable may be bent is too large for the bed or the size",
                                    mm_from_m(least.radius), core::Bound::kAtMost, mm_from_m(most), "mm");
        else if (least.rho < least_rho)
            f = core::error_finding("limit.rho",
                                    "at no size and preload that was tried does the contour bend the cable so little, in one turn",
                                    mm_from_m(least.rho), core::Bound::kAtLeast, mm_from_m(least_rho), "mm");
        else
            f = core::error_finding("limit.wrap", "at no size and preload that was tried does the cable lie on less than a turn",
                                    least.wrap, core::Bound::kAtMost, kWidestWrap, "rad");
        f.where = to_string(part);
        f.source = "docs/theory/cams.md";
        findings.push_back(std::move(f));
    }
    return findings;
}

}  // namespace fusee::search::init
