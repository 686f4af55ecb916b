#include "fusee/design/budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "fusee/actuator/equilibrium.h"
#include "fusee/core/error.h"
#include "fusee/core/parallel.h"
#include "fusee/math/statistics.h"
#include "fusee/math/stream.h"
#include "part_model.h"

namespace fusee::design::budget {

namespace {

constexpr std::size_t kSe = 0, kPe = 1;

/// Errors of both parts and of the gear on one side.
struct SideErrors {
    std::array<PartErrors, 2> parts;
    double friction = 0.0;
};

/// One error that is drawn: its source, part and standard deviation, and where it is written.
struct Drawn {
    Source source;
    std::size_t part;
    double sigma;
    double& (*of)(SideErrors&, std::size_t part);
};

bool is_parallel(const cam::Cam& cam) { return !cam.has_roller() && cam.options.guide.kind == cam::GuideKind::kParallel; }

/// Every independent error of the parts of a side, in the order in which they are drawn.
std::vector<Drawn> drawn_errors(std::span<const PartSubject> parts) {
    using E = SideErrors;
    std::vector<Drawn> all;
    for (std::size_t part = 0; part < parts.size(); ++part) {
        const PartSubject& s = parts[part];
        const Tolerances& t = s.tolerances;
        const bool parallel = is_parallel(*s.cam);
        const auto add = [&](Source source, double limit, double& (*of)(E&, std::size_t)) {
            all.push_back({source, part, 0.5 * limit, of});
        };
        add(Source::kContour, t.contour, [](E& e, std::size_t i) -> double& { return e.parts[i].contour; });
        add(Source::kRunout, t.runout, [](E& e, std::size_t i) -> double& { return e.parts[i].runout.x(); });
        add(Source::kRunout, t.runout, [](E& e, std::size_t i) -> double& { return e.parts[i].runout.y(); });
        add(Source::kGuide, t.of(Source::kGuide, parallel), [](E& e, std::size_t i) -> double& { return e.parts[i].guide; });
        add(Source::kRate, t.rate, [](E& e, std::size_t i) -> double& { return e.parts[i].rate; });
        add(Source::kPreload, t.preload, [](E& e, std::size_t i) -> double& { return e.parts[i].preload; });
        add(Source::kCable, 0.5 * t.cable * s.cam->options.cable_diameter, [](E& e, std::size_t i) -> double& { return e.parts[i].cable; });
        add(Source::kZero, t.zero, [](E& e, std::size_t i) -> double& { return e.parts[i].zero; });
    }
    all.push_back(
        {Source::kFriction, kPe, 0.5 * parts.back().tolerances.friction, [](E& e, std::size_t) -> double& { return e.friction; }});
    return all;
}

/// The torque of two cables, one each way, from those of each (docs/theory/budget.md, eq. 6). An error of the angle's zero is the same for
/// both, every other one is drawn for each. @param both in Nm, of the first; becomes that of both @param back its travel counts down
void subtract(PartBudget& both, const PartBudget& back) {
    constexpr auto kZero = static_cast<std::size_t>(Source::kZero);
    for (std::size_t i = 0; i < both.places.size(); ++i) {
        TorqueError& place = both.places[i];
        const TorqueError& other = back.places[back.places.size() - 1 - i];
        place.torque -= other.torque;
        for (std::size_t k = 0; k < place.sigma.size(); ++k)
            place.sigma[k] = k == kZero ? place.sigma[k] + other.sigma[k] : std::hypot(place.sigma[k], other.sigma[k]);
    }
}

core::Range normal_band(double sigma) { return {-kPercentile * sigma, kPercentile * sigma}; }

/// @param of_spring of a single spring: sigmas in Nm, not relative
PartBudget first_order(const PartModel& model, const PartSubject& subject, std::size_t part, const std::vector<Drawn>& errors,
                       bool of_spring = false) {
    PartBudget budget;
    budget.kind = subject.cam->kind;
    budget.name = to_string(budget.kind);
    budget.parallel = is_parallel(*subject.cam);
    for (std::size_t i = 0; i < kSources; ++i) budget.limits[i] = subject.tolerances.of(static_cast<Source>(i), budget.parallel);
    for (const std::size_t row : model.places()) {
        TorqueError place;
        place.travel = model.travel(row), place.torque = model.torque(row);
        std::array<double, kSources> variance{};
        for (const Drawn& error : errors) {
            if (error.part != part || error.source == Source::kFriction) continue;
            SideErrors one;
            error.of(one, part) = error.sigma;
            const double change = of_spring ? model.change(row, one.parts[part]) : model.linear(row, one.parts[part]);
            variance[static_cast<std::size_t>(error.source)] += change * change;
        }
        std::transform(variance.begin(), variance.end(), place.sigma.begin(), [](double v) { return std::sqrt(v); });
        place.band = normal_band(place.whole());
        budget.places.push_back(place);
    }
    return budget;
}

/// Built joints: springs of each side from its errors, and the dead-band.
class Shop {
public:
    Shop(const Subject& subject, const std::array<PartModel, 2>& models) : rig_(subject.actuator), models_(models) {}

    struct Side {
        std::array<spring::PotentialPtr, 2> springs;
        double zero = 0.0, friction = 1.0;
    };
    [[nodiscard]] Side build(const SideErrors& e) const {
        return {{models_[kSe].spring(e.parts[kSe]), models_[kPe].spring(e.parts[kPe])}, e.parts[kPe].zero, std::max(0.0, 1.0 + e.friction)};
    }
    /// The same with errors of one part only, and of the gear.
    [[nodiscard]] Side rebuild(const Side& side, const SideErrors& e, std::size_t part) const {
        Side rebuilt = side;
        rebuilt.springs[part] = models_[part].spring(e.parts[part]);
        rebuilt.zero = e.parts[kPe].zero, rebuilt.friction = std::max(0.0, 1.0 + e.friction);
        return rebuilt;
    }
    /// Full width at the joint [rad]; NaN if an edge is beyond a spring.
    [[nodiscard]] double width(const Side& a, const Side& b, double tau) const {
        actuator::Joint joint = actuator::antagonist(a.springs[kPe], a.springs[kSe], b.springs[kSe], b.springs[kPe],
                                                     {rig_.gear_friction, rig_.gear_friction}, rig_.capstan_radius, rig_.joint_radius);
        joint.springs.front().offset += a.zero;
        joint.springs.back().offset += b.zero;
        const core::Range first = spring::resting_loads(rig_.gear_friction, tau, a.friction),
                          second = spring::resting_loads(rig_.gear_friction, tau, b.friction);
        if (std::isnan(first.width()) || std::isnan(second.width())) return core::kNan;
        const auto high = actuator::equilibrium(joint, {first.low, second.high, 0.0});
        const auto low = actuator::equilibrium(joint, {first.high, second.low, 0.0});
        return high && low ? high->z(actuator::kOutput) - low->z(actuator::kOutput) : core::kNan;
    }

private:
    const actuator::Actuator& rig_;
    const std::array<PartModel, 2>& models_;
};

/// The drawing, and one side with each error of plus and minus a standard deviation.
struct Differences {
    Shop::Side drawing;
    std::vector<std::array<Shop::Side, 2>> moved;  ///< in the order of the errors
};

Differences differences(const Shop& shop, const std::vector<Drawn>& errors) {
    Differences all{shop.build({}), {}};
    for (const Drawn& error : errors) {
        std::array<Shop::Side, 2> both;
        for (const std::size_t k : {0, 1}) {
            SideErrors one;
            error.of(one, error.part) = k == 0 ? error.sigma : -error.sigma;
            both[k] = shop.rebuild(all.drawing, one, error.part);
        }
        all.moved.push_back(std::move(both));
    }
    return all;
}

/// Central differences of the exact model, one error of one side at a time; an error of the other side moves the width as much.
WidthBudget width_budget(const Shop& shop, double tau, const std::vector<Drawn>& errors, const Differences& sides) {
    WidthBudget budget{.tau = tau,
                       .nominal = shop.width(sides.drawing, sides.drawing, tau),
                       .whole = core::kNan,
                       .band = {core::kNan, core::kNan},
                       .sampled = {core::kNan, core::kNan}};
    std::array<double, kSources> variance{};
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const auto& [plus, minus] = sides.moved[i];
        const double change = 0.5 * (shop.width(plus, sides.drawing, tau) - shop.width(minus, sides.drawing, tau));
        variance[static_cast<std::size_t>(errors[i].source)] += 2.0 * change * change;
    }
    std::transform(variance.begin(), variance.end(), budget.sigma.begin(), [](double v) { return std::sqrt(v); });
    budget.whole = std::sqrt(std::accumulate(variance.begin(), variance.end(), 0.0));
    const double spread = kPercentile * budget.whole / budget.nominal;
    budget.band = {budget.nominal * std::exp(-spread), budget.nominal * std::exp(spread)};
    return budget;
}

/// One sampled joint: relative torque errors at the places of K_SE and K_PE, and the widths.
struct Sample {
    std::array<std::vector<double>, 2> torques;
    std::vector<double> widths;
};

SideErrors draw_side(const math::Stream& stream, std::size_t side, const std::vector<Drawn>& errors) {
    SideErrors drawn;
    for (std::size_t i = 0; i < errors.size(); ++i)
        errors[i].of(drawn, errors[i].part) = errors[i].sigma * stream.normal(2 * (side * errors.size() + i));
    return drawn;
}

Sample sample(const Shop& shop, const std::array<PartModel, 2>& models, std::span<const double> torques, const std::vector<Drawn>& errors,
              const math::Stream& stream) {
    const SideErrors first = draw_side(stream, 0, errors);
    const Shop::Side a = shop.build(first), b = shop.build(draw_side(stream, 1, errors));
    Sample result;
    for (const std::size_t part : {kSe, kPe})
        for (const std::size_t row : models[part].places())
            result.torques[part].push_back(
                a.springs[part]->force(models[part].travel(row) + first.parts[part].zero) / models[part].torque(row) - 1.0);
    for (const double tau : torques) result.widths.push_back(shop.width(a, b, tau));
    return result;
}

/// 5 and 95 % of the values that are not NaN; NaN if fewer than half are left.
core::Range percentiles(std::vector<double> values) {
    const std::size_t all = values.size();
    std::erase_if(values, [](double v) { return std::isnan(v); });
    if (2 * values.size() < all || values.empty()) return {core::kNan, core::kNan};
    std::sort(values.begin(), values.end());
    return {math::quantile(values, 0.05), math::quantile(values, 0.95)};
}

void add_samples(Budget& budget, const Shop& shop, const std::array<PartModel, 2>& models, std::span<const double> torques,
                 const std::vector<Drawn>& errors, const SampleOptions& options) {
    std::vector<Sample> samples(static_cast<std::size_t>(options.draws));
    core::parallel_for(samples.size(), options.jobs,
                       [&](std::size_t i) { samples[i] = sample(shop, models, torques, errors, math::Stream(options.seed, 0, i)); });
    const auto band = [&](const auto& value) {
        std::vector<double> values;
        for (const Sample& s : samples) values.push_back(value(s));
        return percentiles(std::move(values));
    };
    for (const std::size_t part : {kSe, kPe})
        for (std::size_t i = 0; i < budget.parts[part].places.size(); ++i)
            budget.parts[part].places[i].sampled = band([&](const Sample& s) { return s.torques[part][i]; });
    for (std::size_t i = 0; i < budget.widths.size(); ++i) budget.widths[i].sampled = band([&](const Sample& s) { return s.widths[i]; });
}

void validate_parts(std::span<const PartSubject> parts) {
    for (const PartSubject& part : parts)
        for (std::size_t i = 0; i < kSources; ++i)
            if (const double limit = part.tolerances.of(static_cast<Source>(i), false); !(limit >= 0.0 && limit < 1.0))
                throw core::InvalidInput(std::string("tolerances.") + to_string(static_cast<Source>(i)), fmt::format("{}", limit),
                                         "0 to below 1");
}

void validate_subject(const Subject& subject, const SampleOptions& options) {
    validate_parts(subject.parts);
    if (options.draws != 0 && options.draws < 20) throw core::InvalidInput("draws", fmt::format("{}", options.draws), "0, or at least 20");
}

}  // namespace

const char* to_string(Source source) {
    static constexpr std::array kNames{"contour", "runout", "guide", "rate", "preload", "cable", "zero", "friction"};
    return kNames.at(static_cast<std::size_t>(source));
}

double Tolerances::of(Source source, bool parallel) const {
    switch (source) {
        case Source::kContour:
            return contour;
        case Source::kRunout:
            return runout;
        case Source::kGuide:
            return parallel ? direction : guide;
        case Source::kRate:
            return rate;
        case Source::kPreload:
            return preload;
        case Source::kCable:
            return cable;
        case Source::kZero:
            return zero;
        case Source::kFriction:
            return friction;
    }
    return 0.0;
}

double TorqueError::whole() const { return std::sqrt(std::inner_product(sigma.begin(), sigma.end(), sigma.begin(), 0.0)); }

const TorqueError& PartBudget::worst() const {
    return *std::max_element(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.whole() < b.whole(); });
}

Budget budget_of(const Subject& subject, std::span<const double> torques, const SampleOptions& options) {
    validate_subject(subject, options);
    const double radius = subject.actuator.capstan_radius;
    const std::array<PartModel, 2> models{PartModel(subject.parts[kSe], radius), PartModel(subject.parts[kPe], radius)};
    const std::vector<Drawn> errors = drawn_errors(subject.parts);
    const Shop shop(subject, models);
    Budget budget;
    budget.draws = options.draws;
    for (const std::size_t part : {kSe, kPe}) budget.parts.push_back(first_order(models[part], subject.parts[part], part, errors));
    const Differences sides = differences(shop, errors);
    for (const double tau : torques) budget.widths.push_back(width_budget(shop, tau, errors, sides));
    if (options.draws > 0) add_samples(budget, shop, models, torques, errors, options);
    return budget;
}

Budget budget_of_spring(std::span<const PartSubject> subjects, double capstan_radius, const std::string& name) {
    validate_parts(subjects);
    const auto of_one = [&](const PartSubject& subject) {
        return first_order(PartModel(subject, capstan_radius), subject, 0, drawn_errors({&subject, 1}), true);
    };
    Budget budget;
    budget.parts = {of_one(subjects.front())};
    PartBudget& part = budget.parts.front();
    part.name = name;
    if (subjects.size() == 2) subtract(part, of_one(subjects.back()));
    double largest = 0.0;
    for (const TorqueError& place : part.places) largest = std::max(largest, std::abs(place.torque));
    for (TorqueError& place : part.places) {
        for (double& sigma : place.sigma) sigma /= largest;
        place.band = normal_band(place.whole());
    }
    return budget;
}

std::vector<Needed> tolerances_for_torque(const PartBudget& part, double wanted) {
    constexpr double kNoInfluence = 1e-12;  // rounding
    core::require_positive("wanted", wanted);
    std::vector<Needed> all;
    for (std::size_t i = 0; i < kSources; ++i) {
        double most = 0.0;
        for (const TorqueError& place : part.places) most = std::max(most, place.sigma[i]);
        const double stated = part.limits[i];
        if (most <= kNoInfluence || stated <= 0.0) continue;
        all.push_back({static_cast<Source>(i), stated, stated * wanted / (kPercentile * most), 0.0});
    }
    for (Needed& needed : all) needed.shared = needed.alone / std::sqrt(static_cast<double>(all.size()));
    return all;
}

}  // namespace fusee::design::budget
