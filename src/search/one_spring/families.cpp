#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "changed_law.h"
#include "fix/judge.h"
#include "fusee/design/evolution.h"
#include "fusee/pipeline/check.h"
#include "fusee/spring/coil.h"
#include "init/springs.h"

namespace fusee::search::one_spring {

namespace {

using pipeline::Depth;

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
    FamilySearch(const profile::Profile& from, const std::string& name, const Task& task, const Options& options, Freedom freedom)
        : options_(options),
          task_(task),
          freedom_(freedom),
          keeps_pulley_(std::get<profile::OneSpring>(from.law.curves).family == profile::OneSpring::Family::kSpool),
          from_(from),
          base_(in_family(from, name)),
          sold_(options.catalogue.of(base_.part(base_.part_kinds().front()).spring.kind)),
          variables_(variables_of(name, base_, task, keeps_pulley_, freedom)) {
        family_.name = name;
    }

    Family run() {
        const Draft best = must_push() ? Draft{} : evolve();
        if (options_.front) add_front();
        const auto seen = allowed([&] { return pipeline::evaluate(drawn_of(best), Depth::kOutline); });
        if (seen && seen->passed() && wound(best)) {
            if (freedom_ == Freedom::kLaw) bring_nearer();
            return std::move(family_);
        }
        if (seen && family_.findings.empty()) family_.findings = fix::broken_in(seen->all(), core::Severity::kError);
        if (const core::Findings binding = family_.findings; is_own() && sold_.empty() && !made(from_)) family_.findings = binding;
        return std::move(family_);
    }

    /// The answer that the search may change, where with that change alone a part with a spring is found; first the size of the change.
    std::optional<std::pair<double, Family::Lever>> lever() {
        if (must_push()) return std::nullopt;
        Draft best = evolve();
        if (!with_more(best)) return std::nullopt;
        const double first = std::get<profile::OneSpring>(from_.law.curves).first_angle(), bed = from_.process.build_x;
        Family::Lever lever{"bed", best.bed * bed, bed};
        if (freedom_ == Freedom::kTorque) lever = {"torque", best.share * task_.torque, task_.torque};
        if (freedom_ == Freedom::kRange) lever = {"range", first + best.kept * task_.travel, first + task_.travel};
        return std::pair{change_of(best), lever};
    }

private:
    /// Changes the draft more, until it is a part whose spring can be wound.
    [[nodiscard]] bool with_more(Draft& draft) const {
        const Draft least = draft;
        for (const double more : {1.0, 1.1, 1.3, 1.7, 2.5, 5.0}) {
            draft = least;
            if (freedom_ == Freedom::kTorque) draft.share /= more;
            if (freedom_ == Freedom::kRange) draft.kept /= more;
            if (freedom_ == Freedom::kBed) draft.bed *= more;
            const auto seen = judged(draft, Depth::kOutline);
            if (!seen || !seen->passed()) continue;
            const auto wound = fix::if_allowed([&] { return with_wound_spring(drawn_of(draft)); });
            if (wound && *wound) return true;
        }
        return false;
    }
    /// A single cable cannot: no part of this family is worth a search.
    [[nodiscard]] bool must_push() const {
        const bool pulls =
            std::get<profile::OneSpring>(base_.law.curves).family != profile::OneSpring::Family::kRoller && !base_.has_two_cables();
        return pulls && *std::min_element(task_.torques.begin(), task_.torques.end()) <= 0.0;
    }
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
        return fix::if_allowed([&] { return pipeline::evaluate(drawn_of(draft), depth); });
    }
    [[nodiscard]] profile::Profile drawn_of(const Draft& draft) const {
        if (freedom_ == Freedom::kNone) return drawn(base_, draft, task_, keeps_pulley_, sold_);
        if (freedom_ == Freedom::kBed) {
            profile::Profile p = base_;
            for (double* side : {&p.process.build_x, &p.process.build_y, &p.process.build_z}) *side *= draft.bed;
            return drawn(std::move(p), draft, task_, keeps_pulley_, sold_);
        }
        const Task task = changed_task(task_, draft);
        return drawn(with_law(base_, task, points_of(task)), draft, task, keeps_pulley_, sold_);
    }
    /// As asked, the room; else the change, and some of the room.
    [[nodiscard]] double price_of(const pipeline::Evaluation& seen, const Draft& draft) const {
        const double of_room = freedom_ == Freedom::kLaw ? 1e-3 : 0.3;  // of a lever more: a spring is to be wound
        const double cost = cost_of(seen, drawn_of(draft));
        if (freedom_ == Freedom::kNone || cost >= kRefused) return cost;
        return change_of(draft) + of_room * cost;
    }
    /// Of the law over its largest torque, or of one number by its logarithm.
    [[nodiscard]] double change_of(const Draft& draft) const {
        if (freedom_ != Freedom::kLaw) return std::abs(std::log(draft.share * draft.kept * draft.bed));
        return distance(changed_task(task_, draft).torques, task_.torques) / task_.torque;
    }

    [[nodiscard]] Draft evolve() {
        const auto cost = [&](std::span<const double> x) {
            const Draft draft = entered(Draft{}, variables_, x);
            const auto seen = judged(draft, Depth::kOutline);
            return seen ? price_of(*seen, draft) : core::kNan;
        };
        design::EvolutionOptions evolution;
        evolution.bounds = bounds_of(variables_);
        evolution.population = 24;
        evolution.generations = options_.generations;
        evolution.tolerance = 1e-4;
        evolution.jobs = options_.jobs;
        evolution.stop = options_.stop ? options_.stop : [] { return false; };
        if (options_.front && freedom_ == Freedom::kNone)
            evolution.observe = [&](std::span<const double> x, double cost_of_x) {
                if (cost_of_x < kRefused) passed_.emplace_back(cost_of_x, std::vector<double>(x.begin(), x.end()));
            };
        const design::EvolutionResult found = design::evolve(cost, evolution);
        if (found.interrupted) throw core::Stopped();
        family_.judged = found.evaluations;
        family_.missing = found.cost;
        return entered(Draft{}, variables_, found.best);
    }

    /// From up to 60 of the candidates without an error, from the smallest to the largest.
    void add_front() {
        constexpr std::size_t kMost = 60;
        std::sort(passed_.begin(), passed_.end());
        std::vector<Family::Candidate> all;
        for (std::size_t i = 0; i < std::min(kMost, passed_.size()); ++i) {
            const Draft draft = entered(Draft{}, variables_, passed_[i * passed_.size() / std::min(kMost, passed_.size())].second);
            if (const auto seen = judged(draft, Depth::kOutline); seen && seen->passed())
                all.push_back(candidate_of(*seen, drawn_of(draft), task_.torque));
        }
        const auto figures = [](const Family::Candidate& c) {
            return std::array{c.room(), c.built_error, std::isnan(c.guide_friction) ? 0.0 : c.guide_friction};
        };
        const auto beats = [&](const Family::Candidate& a, const Family::Candidate& b) {
            const auto one = figures(a), other = figures(b);
            return one != other && std::equal(one.begin(), one.end(), other.begin(), std::less_equal<>());
        };
        for (const Family::Candidate& c : all)
            if (std::none_of(all.begin(), all.end(), [&](const auto& other) { return beats(other, c); })) family_.front.push_back(c);
        std::stable_sort(family_.front.begin(), family_.front.end(), [](const auto& a, const auto& b) { return a.room() < b.room(); });
    }

    /// With a spring of the catalogue, or one that can be wound, whose rate is not quite the wanted one: a little more room where it is
    /// needed.
    bool wound(Draft draft) {
        const cam::PartKind kind = base_.part_kinds().front();
        for (const double more : {1.0, 1.03, 1.08, 1.15, 1.25}) {
            Draft wider = draft;
            wider.base *= more, wider.turn /= more, wider.rib *= more;
            const profile::Profile candidate = drawn_of(wider);
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

    /// The law of the part found comes as near to the wanted one as no rule breaks.
    void bring_nearer() {
        const Family first = family_;
        const std::vector<double> wanted = points_of(task_);
        const auto with = [&](const std::vector<double>& points) { return with_law(*first.profile, task_, points); };
        const auto holds = [&](const std::vector<double>& points) {
            if (options_.stop && options_.stop()) throw core::Stopped();
            const auto seen = fix::if_allowed([&] { return pipeline::evaluate(with(points), Depth::kOutline); });
            return seen && seen->passed();
        };
        if (!made(with(nearest_points(*first.profile, wanted, holds)))) family_ = first;
        const profile::Rows& rows = std::get<profile::OneSpring>(family_.profile->law.curves).rows;
        Family::ChangedLaw changed{rows.x, wanted, rows.y, distance(rows.y, wanted)};
        for (std::size_t i = 0; i < wanted.size(); ++i) changed.greatest = std::max(changed.greatest, std::abs(rows.y[i] - wanted[i]));
        family_.changed = std::move(changed);
    }

    /// Judged as it will be read.
    bool made(const profile::Profile& candidate) {
        const profile::Profile profile = profile::parse_profile(profile::to_commented_toml(candidate), candidate.file);
        const auto seen = allowed([&] { return pipeline::evaluate(profile, Depth::kSolid); });
        if (!seen) return false;
        family_.findings = seen->all();
        if (!seen->passed()) {
            family_.findings = fix::broken_in(family_.findings, core::Severity::kError);
            return false;
        }
        family_.figures = figures_of(*seen, profile, task_.torque);
        family_.profile = profile;
        return !options_.files || carried();
    }

    /// The files must carry the law: a small part may need a finer mesh than the profile's.
    bool carried() {
        constexpr int kFiner = 5;
        constexpr const char* kKey = "tolerances.chordal_error_mm";
        constexpr double kBetter = 0.9;
        profile::Profile p = *std::exchange(family_.profile, std::nullopt);
        double before = std::numeric_limits<double>::infinity();  // figure over limit
        for (int i = 0; i < kFiner; ++i) {
            const auto seen = allowed([&] { return pipeline::evaluate(p, Depth::kFiles); });
            if (!seen) return false;
            const core::Findings all = seen->all(), errors = fix::broken_in(all, core::Severity::kError);
            family_.findings = errors.empty() ? all : errors;
            if (errors.empty()) return family_.profile = std::move(p), true;
            double beyond = 0.0;
            for (const core::Finding& f : errors) beyond = std::max(beyond, f.measured / f.allowed);
            if (beyond > kBetter * before) return false;  // it is not the mesh
            before = beyond;
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
    Freedom freedom_;
    bool keeps_pulley_;
    const profile::Profile& from_;
    profile::Profile base_;
    const std::vector<spring::CatalogueSpring>& sold_;
    std::vector<Variable<Draft>> variables_;
    std::vector<std::pair<double, std::vector<double>>> passed_;  ///< candidates without an error, by their cost
    Family family_;
};

/// That a family's part moves.
spring::BaseKind spring_kind_of(const std::string& family) {
    return family == "spool" ? spring::BaseKind::kTorsion : spring::BaseKind::kCompression;
}

std::vector<Family> find_each(const profile::Profile& profile, const Task& task, const Options& options, Freedom freedom) {
    std::vector<Family> all;
    for (const std::string& name : options.families) {
        if (name == "two_cables" && !task.has_both_signs()) continue;  // one cable does it
        if (options.progress) options.progress(name);
        all.push_back(FamilySearch(profile, name, task, options, freedom).run());
    }
    return all;
}

/// A third of the generations for each: an answer within seconds.
void add_levers(const profile::Profile& profile, const Task& task, Options options, std::vector<Family>& families) {
    const auto farther = [](const Family& a, const Family& b) {
        return std::pair{a.missing == 0.0, a.missing} < std::pair{b.missing == 0.0, b.missing};
    };
    const auto nearest = std::min_element(families.begin(), families.end(), farther);
    if (nearest == families.end()) return;
    if (options.progress) options.progress("what would make a part possible");
    options.generations = std::max(1, options.generations / 3);
    std::vector<std::pair<double, Family::Lever>> found;
    for (const Freedom freedom : {Freedom::kTorque, Freedom::kRange, Freedom::kBed})
        if (const auto lever = FamilySearch(profile, nearest->name, task, options, freedom).lever()) found.push_back(*lever);
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& lever : found) nearest->levers.push_back(std::move(lever.second));
}

/// Those for which the catalogue has springs, if there is one.
std::vector<std::string> families_with_springs(const Options& options) {
    std::vector<std::string> all = options.families;
    if (!options.catalogue.torsion.empty() || !options.catalogue.compression.empty())
        std::erase_if(all, [&](const std::string& name) { return options.catalogue.of(spring_kind_of(name)).empty(); });
    return all;
}

}  // namespace

std::vector<Family> find_smallest(const profile::Profile& profile, const Options& asked) {
    Options options = asked;
    options.families = families_with_springs(asked);
    std::vector<Family> all;
    const auto task = task_of(profile);
    if (!task) {
        for (const std::string& name : options.families) all.push_back({.name = name, .findings = task.refusal()});
        return all;
    }
    const auto none_found = [&] { return std::none_of(all.begin(), all.end(), [](const Family& family) { return family.found(); }); };
    all = find_each(profile, *task, options, Freedom::kNone);
    if (none_found() && options.repair) all = find_each(profile, *task, options, Freedom::kLaw);
    if (none_found()) add_levers(profile, *task, options, all);
    return all;
}

const Family* smallest(const std::vector<Family>& families) {
    const Family* best = nullptr;
    const auto rank = [](const Family& family) { return std::pair{family.changed ? family.changed->mean : 0.0, family.figures.room()}; };
    for (const Family& family : families)
        if (family.found() && (best == nullptr || rank(family) < rank(*best))) best = &family;
    return best;
}

}  // namespace fusee::search::one_spring
