#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "draft.h"
#include "fix/judge.h"
#include "fusee/core/error.h"
#include "fusee/design/evolution.h"
#include "fusee/pipeline/budget.h"
#include "fusee/pipeline/check.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/search/one_spring.h"
#include "fusee/solid/mesh.h"
#include "fusee/spring/coil.h"
#include "init/springs.h"

namespace fusee::search::one_spring {

namespace {

using pipeline::Depth;

constexpr double kRefused = 1e3, kUnseen = 100.0;   // cost of a draft that breaks a rule, of a step that was not reached
constexpr double kReview = 0.1, kMostReview = 2.0;  // a warning is worth this share of the room, and more as it is beyond its limit
// Energy over the room of a wound spring's coils, of those of profiles/single [J/m^3].
constexpr double kTorsionDensity = 0.3e6, kCompressionDensity = 0.14e6;

constexpr double kPlainBearing = 0.15;  // coefficient of friction, dry

core::Findings broken_in(const core::Findings& all, core::Severity severity) {
    core::Findings broken;
    std::copy_if(all.begin(), all.end(), std::back_inserter(broken), [=](const core::Finding& f) { return f.severity == severity; });
    return broken;
}

constexpr double kFarthest = 9.0;

/// How far a figure is beyond its limit, in e-folds, at most 9.
double e_folds_beyond(const core::Finding& f) {
    const double ratio = f.bound == core::Bound::kAtMost ? f.measured / f.allowed : f.allowed / f.measured;
    return ratio > 1.0 ? std::min(kFarthest, std::log(ratio)) : kFarthest;
}

/// The same of a limit that its figure does not come nearer to step by step (a curvature below 0): how far the base radius is from the one
/// that the finding asks for.
double e_folds_beyond(const core::Finding& f, const profile::PartSpec& spec) {
    for (const core::Changes& changes : f.suggestion.changes())
        if (changes.front().key == "cam.roller.base_radius_mm")
            return std::min(kFarthest, std::abs(std::log(core::m_from_mm(std::stod(changes.front().value)) / spec.cam.roller.base_radius)));
    return e_folds_beyond(f);
}

/// Diameter and height of the cylinder about the axis around a part [m].
Figures cylinder(const solid::Part& body) {
    double radius = 0.0;
    const cam::Cam& cam = body.cam;
    const double step = cam.groove_psi.width() / 360.0;
    for (int i = 0; i <= 360; ++i) {
        const cam::PathPoint p = cam.path(cam.groove_psi.low + i * step);
        radius = std::max(radius, std::hypot(p.h, p.slope));
    }
    double lips = 0.0;
    for (const solid::SectionPoint& p : body.section) lips = std::max(lips, core::m_from_mm(p.offset_mm));
    Figures figures;
    figures.diameter = 2.0 * (radius + lips + body.options.flange_height);
    figures.height = body.z_high - body.z_low + body.options.hub.boss_height;
    return figures;
}

/// That the coils of a spring fill, unloaded [m^3].
double coils(const spring::BaseSpring& s) {
    const double outside = s.coil_diameter + s.wire_diameter;
    const double length = s.kind == spring::BaseKind::kTorsion ? (s.active_coils + 1.0) * s.wire_diameter : s.free_length;
    return 0.25 * core::kPi * outside * outside * length;
}

double room(const Figures& f) { return 0.25 * core::kPi * f.diameter * f.diameter * f.height + f.spring_volume; }

/// The room of a part and of a spring that holds the energy, or how far the draft is from being one.
double cost_of(const pipeline::Evaluation& seen, const profile::Profile& draft) {
    const core::Findings all = seen.all(), errors = broken_in(all, core::Severity::kError);
    const auto has = [&](const auto& what) { return !seen.parts.empty() && std::all_of(seen.parts.begin(), seen.parts.end(), what); };
    const bool whole = has([](const pipeline::EvaluatedPart& part) { return part.reached == Depth::kOutline; });
    if (!whole || !errors.empty()) {
        double cost = kRefused;
        if (!seen.design) cost += 2.0 * kUnseen;
        if (!whole) cost += has([](const pipeline::EvaluatedPart& part) { return part.cam.has_value(); }) ? kUnseen : 2.0 * kUnseen;
        for (const core::Finding& f : errors) cost += 1.0 + e_folds_beyond(f, draft.part(draft.part_kinds().front()));
        return cost;
    }
    double reviews = 1.0, needed = 0.0;
    for (const pipeline::EvaluatedPart& part : seen.parts) {
        double state = 0.0;
        for (const cam::Contact& c : part.cam->working) state = std::max(state, c.arm.state);
        const bool torsion = part.kind == cam::PartKind::kSeries;
        Figures figures = cylinder(*part.body);
        const spring::BaseSpring& s = draft.part(part.kind).spring;
        figures.spring_volume =
            spring::coil_known(s) ? coils(s) : 0.5 * s.rate * state * state / (torsion ? kTorsionDensity : kCompressionDensity);
        needed += room(figures);
    }
    for (const core::Finding& f : broken_in(all, core::Severity::kWarning)) reviews += kReview + std::min(kMostReview, e_folds_beyond(f));
    const double size = 1e6 * needed * reviews;  // [cm^3]
    return size / (1e3 + size);                  // below 1, whatever the size
}

/// The greatest torque that slide or pivot of a roller takes as a plain bearing [Nm]; NaN: no roller.
double guide_friction(const cam::Cam& cam) {
    if (!cam.has_roller()) return core::kNan;
    double most = 0.0;
    for (const cam::Contact& c : cam.working) most = std::max(most, cam::guide_friction(c.arm, cam.options, kPlainBearing));
    return most;
}

/// Figure over limit, of several parts the worst; NaN: not judged.
double share_used(const core::Findings& findings, const char* rule) {
    double worst = core::kNan;
    for (const core::Finding& f : findings) {
        if (f.rule != rule || f.severity == core::Severity::kNotJudged) continue;
        const double share = f.measured / f.allowed;
        worst = f.bound == core::Bound::kAtMost ? std::fmax(worst, share) : std::fmin(worst, share);
    }
    return worst;
}

/// Part, or both parts of two cables one on the other, with what they are like; but for the rules.
Figures part_figures(const pipeline::Evaluation& seen) {
    Figures all;
    std::vector<const cam::Cam*> cams;
    const std::vector<pipeline::AskedPart> asked = pipeline::parts_of(*seen.design);
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const solid::Part& body = *seen.parts[i].body;
        const Figures one = cylinder(body);
        all.diameter = std::max(all.diameter, one.diameter);
        all.height += one.height;
        all.volume += 1e-9 * solid::volume_mm3(body.mesh);
        all.spring_volume += coils(asked[i].design->spec(asked[i].kind).spring);
        cams.push_back(&*seen.parts[i].cam);
    }
    all.built_error = pipeline::spring_budget(*seen.design, cams).parts.front().worst().band.high;
    return all;
}

/// The profile with a spring that can be wound for its part; of two cables with that for the one whose spring has the larger load, and the
/// other's preload by its first load.
core::Outcome<profile::Profile> with_wound_spring(const profile::Profile& profile) {
    if (!profile.has_two_cables()) return init::with_spring(profile, profile.part_kinds().front());
    const auto design = pipeline::resolve(profile);
    if (!design) return design.refusal();
    const auto load = [](const pipeline::ResolvedDesign& way) {
        const double held = way.law()->at_load(way.law()->loads().high).u_pe;
        return way.profile.k_pe.spring.load(held);
    };
    const bool back = load(design->ways[1]) > load(design->ways[0]);
    const auto wound = init::with_spring(design->ways[back ? 1 : 0].profile, cam::PartKind::kParallel);
    if (!wound) return wound.refusal();
    profile::Profile both = profile;
    auto& two = std::get<profile::OneSpring>(both.law.curves).two_cables;
    const double softer = profile.k_pe.spring.rate / wound->k_pe.spring.rate, first = profile.k_pe.spring.preload;
    both.k_pe.spring = wound->k_pe.spring;
    if (back)
        two.back_preload = wound->k_pe.spring.preload, both.k_pe.spring.preload = softer * first;
    else
        two.back_preload *= softer;
    return profile::rounded(std::move(both), init::kSpringDigits);
}

/// A candidate with a value that is not allowed: what is asked of that key.
core::Finding not_allowed(const core::InvalidInput& e) {
    core::Finding f = core::error_finding(
        "search.value", fmt::format("the nearest candidate has {} = {}; allowed is {}", e.field(), e.value(), e.allowed()), 0.0,
        core::Bound::kAtLeast, 1.0, "candidates");
    f.where = "cam";
    f.suggestion = e.field() + ": " + e.allowed();
    return f;
}

/// The search of one family.
class FamilySearch {
public:
    FamilySearch(const profile::Profile& from, const std::string& name, const Task& task, const Options& options)
        : options_(options),
          task_(task),
          keeps_pulley_(std::get<profile::OneSpring>(from.law.curves).family == profile::OneSpring::Family::kSpool),
          from_(from),
          base_(in_family(from, name)),
          sold_(options.catalogue.of(base_.part(base_.part_kinds().front()).spring.kind)),
          variables_(variables_of(name, base_, task, keeps_pulley_)) {
        family_.name = name;
    }

    Family run() {
        const Draft best = evolve();
        const auto seen = allowed([&] { return pipeline::evaluate(drawn(base_, best, task_, keeps_pulley_, sold_), Depth::kOutline); });
        if (seen && seen->passed() && wound(best)) return std::move(family_);
        if (seen && family_.findings.empty()) family_.findings = broken_in(seen->all(), core::Severity::kError);
        if (const core::Findings binding = family_.findings; is_own() && sold_.empty() && !made(from_)) family_.findings = binding;
        return std::move(family_);
    }

private:
    /// The profile's part is of this family, its spring known: where the search finds none, that part may stand.
    [[nodiscard]] bool is_own() const {
        const auto family = [](const profile::Profile& p) { return std::get<profile::OneSpring>(p.law.curves).family; };
        const profile::PartSpec &own = from_.part(from_.part_kinds().front()), &wanted = base_.part(base_.part_kinds().front());
        return family(from_) == family(base_) && own.cam.path.kind == wanted.cam.path.kind &&
               own.cam.roller.follower == wanted.cam.roller.follower && spring::coil_known(own.spring);
    }
    /// The result of `work`; none if a value of the candidate is not allowed, which is then what binds.
    template <class Work>
    auto allowed(const Work& work) -> std::optional<decltype(work())> {
        core::Mistakes mistakes;
        std::optional<decltype(work())> result;
        if (!mistakes.collect([&] { result.emplace(work()); })) family_.findings = {not_allowed(mistakes.all().front())};
        return result;
    }
    [[nodiscard]] std::optional<pipeline::Evaluation> judged(const Draft& draft, Depth depth) const {
        return fix::if_allowed([&] { return pipeline::evaluate(drawn(base_, draft, task_, keeps_pulley_, sold_), depth); });
    }

    [[nodiscard]] Draft evolve() {
        const auto cost = [&](std::span<const double> x) {
            const Draft draft = entered(Draft{}, variables_, x);
            const auto seen = judged(draft, Depth::kOutline);
            return seen ? cost_of(*seen, drawn(base_, draft, task_, keeps_pulley_, sold_)) : core::kNan;
        };
        design::EvolutionOptions evolution;
        evolution.bounds = bounds_of(variables_);
        evolution.population = 24;
        evolution.generations = options_.generations;
        evolution.tolerance = 1e-4;
        evolution.jobs = options_.jobs;
        evolution.stop = options_.stop ? options_.stop : [] { return false; };
        const design::EvolutionResult found = design::evolve(cost, evolution);
        if (found.interrupted) throw core::Stopped();
        family_.judged = found.evaluations;
        return entered(Draft{}, variables_, found.best);
    }

    /// With a spring of the catalogue, or one that can be wound, whose rate is not quite the wanted one: a little more room where it is
    /// needed.
    bool wound(Draft draft) {
        const cam::PartKind kind = base_.part_kinds().front();
        for (const double more : {1.0, 1.03, 1.08, 1.15, 1.25}) {
            Draft wider = draft;
            wider.base *= more, wider.turn /= more, wider.rib *= more;
            const profile::Profile candidate = drawn(base_, wider, task_, keeps_pulley_, sold_);
            if (!sold_.empty()) {
                if (!made(candidate)) continue;
                family_.bought = nearest_sold(sold_, candidate.part(kind).spring.rate).name;
                return true;
            }
            const auto with_spring = allowed([&] { return with_wound_spring(candidate); });
            if (!with_spring) continue;
            if (!*with_spring) {
                family_.findings = with_spring->refusal();
                continue;
            }
            if (made(**with_spring)) return true;
        }
        return false;
    }

    /// Judged as it will be read.
    bool made(const profile::Profile& candidate) {
        const profile::Profile profile = profile::parse_profile(profile::to_commented_toml(candidate), candidate.file);
        const auto seen = allowed([&] { return pipeline::evaluate(profile, Depth::kSolid); });
        if (!seen) return false;
        family_.findings = seen->all();
        if (!seen->passed()) {
            family_.findings = broken_in(family_.findings, core::Severity::kError);
            return false;
        }
        Figures& f = family_.figures = part_figures(*seen);
        f.guide_friction = guide_friction(*seen->parts.front().cam) / task_.torque;
        f.stress_share = share_used(family_.findings, "spring.stress");
        f.fatigue_safety = share_used(family_.findings, "spring.fatigue");
        family_.profile = profile;
        return !options_.files || carried();
    }

    /// The files must carry the law: a small part may need a finer mesh than the profile's.
    bool carried() {
        constexpr int kFiner = 3;
        constexpr const char* kKey = "tolerances.chordal_error_mm";
        profile::Profile p = *std::exchange(family_.profile, std::nullopt);
        for (int i = 0; i < kFiner; ++i) {
            const auto seen = allowed([&] { return pipeline::evaluate(p, Depth::kFiles); });
            if (!seen) return false;
            const core::Findings all = seen->all(), errors = broken_in(all, core::Severity::kError);
            family_.findings = errors.empty() ? all : errors;
            if (errors.empty()) return family_.profile = std::move(p), true;
            double finer = 0.4 * core::mm_from_m(p.k_se.solid.chordal_error);
            for (const core::Finding& f : errors)
                for (const core::Changes& changes : f.suggestion.changes())
                    if (changes.front().key == kKey) finer = std::min(finer, std::stod(changes.front().value));
            for (profile::PartSpec* part : {&p.k_se, &p.k_pe}) part->solid.chordal_error = core::m_from_mm(finer);
        }
        return false;
    }

    const Options& options_;
    const Task& task_;
    bool keeps_pulley_;
    const profile::Profile& from_;
    profile::Profile base_;
    const std::vector<spring::CatalogueSpring>& sold_;
    std::vector<Variable<Draft>> variables_;
    Family family_;
};

/// That a family's part moves.
spring::BaseKind spring_kind_of(const std::string& family) {
    return family == "spool" ? spring::BaseKind::kTorsion : spring::BaseKind::kCompression;
}

}  // namespace

std::vector<Family> find_smallest(const profile::Profile& profile, const Options& options) {
    const auto task = task_of(profile);
    std::vector<Family> all;
    const bool sold = !options.catalogue.torsion.empty() || !options.catalogue.compression.empty();
    for (const std::string& name : options.families) {
        if (sold && options.catalogue.of(spring_kind_of(name)).empty()) continue;
        if (name == "two_cables" && task && !task->has_both_signs()) continue;  // one cable does it
        if (options.progress) options.progress(name);
        if (task)
            all.push_back(FamilySearch(profile, name, *task, options).run());
        else
            all.push_back({.name = name, .findings = task.refusal()});
    }
    return all;
}

const Family* smallest(const std::vector<Family>& families) {
    const Family* best = nullptr;
    for (const Family& family : families)
        if (family.found() && (best == nullptr || room(family.figures) < room(best->figures))) best = &family;
    return best;
}

}  // namespace fusee::search::one_spring
