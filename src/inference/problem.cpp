#include "fusee/inference/problem.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fusee/core/error.h"
#include "fusee/core/parallel.h"
#include "fusee/core/text.h"
#include "fusee/core/units.h"

namespace fusee::inference {

Problem::Problem(const Model& model, double width) : model_(model), width_(width) {
    std::vector<double> roots;
    for (std::size_t e = 0; e < model.experiments().size(); ++e) {
        const Experiment& experiment = model.experiments()[e];
        experiment_of_.insert(experiment_of_.end(), experiment.size(), e);
        roots.insert(roots.end(), experiment.size(), std::sqrt(experiment.weight));
    }
    rows_ = static_cast<int>(roots.size());
    has_figures_ = std::any_of(build().begin(), build().end(), [&](const BuildParameter& own) {
        return std::any_of(model.effects().begin(), model.effects().end(), [&](const Effect& effect) { return effect.id == own.name; });
    });
    root_weight_ = Eigen::Map<const Eigen::VectorXd>(roots.data(), rows_);
}

int Problem::dimension(const Causes& causes) const {
    std::size_t n = build().size();
    for (const Cause& cause : causes) n += effect(cause.id).parameters.size();
    return static_cast<int>(n);
}

const Effect& Problem::effect(const std::string& id) const {
    const std::vector<Effect>& library = model_.effects();
    const auto found = std::find_if(library.begin(), library.end(), [&](const Effect& effect) { return effect.id == id; });
    if (found != library.end()) return *found;
    std::vector<std::string> ids;
    for (const Effect& effect : library) ids.push_back(effect.id);
    throw core::InvalidInput("effects: id", id, fmt::format("{}{}", fmt::join(ids, ", "), core::did_you_mean(id, ids)));
}

/// Calls visit(effect, number of its parameter, index in x) for the parameters of all causes.
template <typename Visit>
void Problem::visit_parameters(const Causes& causes, const Visit& visit) const {
    std::size_t first = build().size();
    for (const Cause& cause : causes) {
        const Effect& own = effect(cause.id);
        for (std::size_t k = 0; k < own.parameters.size(); ++k) visit(own, k, static_cast<int>(first++));
    }
}

core::Range Problem::allowed(const Causes& causes, int parameter) const {
    core::Range range{-8.0 * width_, 8.0 * width_};
    visit_parameters(causes, [&](const Effect& effect, std::size_t k, int i) {
        const EffectParameter& p = effect.parameters[k];
        if (i == parameter) range = {p.allowed.low / p.scale, p.allowed.high / p.scale};
    });
    return range;
}

Eigen::VectorXd Problem::start(const Causes& causes) const {
    Eigen::VectorXd x = prior_mean(causes);
    visit_parameters(causes, [&](const Effect& effect, std::size_t k, int i) {
        if (k == 0) x[i] = effect.starts.front();
    });
    return x;
}

Eigen::VectorXd Problem::as_stated(const Eigen::VectorXd& null) const {
    Eigen::VectorXd x = start({});
    for (std::size_t k = 0; k < build().size(); ++k)
        if (const auto i = static_cast<Eigen::Index>(k); !build()[k].stated) x[i] = null[i];
    return x;
}

Eigen::VectorXd Problem::prior_mean(const Causes& causes) const {
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(dimension(causes));
    visit_parameters(causes, [&](const Effect& effect, std::size_t k, int i) {
        if (k > 0) mean[i] = effect.parameters[k].at_first / effect.parameters[k].scale;
    });
    return mean;
}

int Problem::effect_size_index(const Causes& causes, std::size_t cause) const {
    return dimension(Causes(causes.begin(), causes.begin() + static_cast<std::ptrdiff_t>(cause)));
}

Eigen::VectorXd Problem::without(const Causes& causes, const Eigen::VectorXd& x, std::size_t cause) const {
    const int from = effect_size_index(causes, cause), to = effect_size_index(causes, cause + 1);
    Eigen::VectorXd left(x.size() - (to - from));
    left << x.head(from), x.tail(x.size() - to);
    return left;
}

Eigen::VectorXd Problem::with_positive_ripples(const Causes& causes, Eigen::VectorXd x) const {
    for (std::size_t c = 0; c < causes.size(); ++c) {
        const Effect& own = effect(causes[c].id);
        if (!own.has_phase()) continue;
        double& amplitude = x[effect_size_index(causes, c)];
        double& phase = x[effect_size_index(causes, c + 1) - 1];
        const double scale = own.parameters.back().scale, turned = scale * phase + (amplitude < 0.0 ? core::kPi : 0.0);
        phase = std::remainder(turned, 2.0 * core::kPi) / scale;
        amplitude = std::abs(amplitude);
    }
    return x;
}

double Problem::prior_sigma(const Causes& causes, int parameter) const {
    const Role own = role(causes, parameter);
    return own == Role::kSize ? kEffectPrior : own == Role::kBuild ? width_ : 1.0;
}

Problem::Role Problem::role(const Causes& causes, int parameter) const {
    Role role = Role::kBuild;
    visit_parameters(causes, [&](const Effect& effect, std::size_t k, int i) {
        if (i != parameter) return;
        role = k == 0 ? Role::kSize : Role::kFurther;
        if (k > 0 && effect.has_phase()) role = k + 1 == effect.parameters.size() ? Role::kPhase : Role::kCount;
    });
    return role;
}

Setting Problem::setting(const Causes& causes, const Eigen::VectorXd& x) const {
    Setting setting;
    for (std::size_t i = 0; i < build().size(); ++i) setting.build.push_back(x[static_cast<int>(i)] * build()[i].sigma);
    auto next = static_cast<int>(build().size());
    for (const Cause& cause : causes) {
        Setting::Applied applied{cause, {}};
        for (const EffectParameter& p : effect(cause.id).parameters)
            applied.values.push_back(std::clamp(x[next++] * p.scale, p.allowed.low, p.allowed.high));
        setting.effects.push_back(std::move(applied));
    }
    return setting;
}

std::vector<Outputs> Model::predict_each(const std::vector<Setting>& settings, Extent extent) const {
    std::vector<Outputs> all;
    for (const Setting& setting : settings) try {
            all.push_back(predict(setting, extent));
        } catch (const Refusal&) {
            all.emplace_back();
        }
    return all;
}

std::vector<Outputs> Problem::predict_each(const Causes& causes, const std::vector<Eigen::VectorXd>& places, Extent extent) const {
    std::vector<Setting> settings;
    settings.reserve(places.size());
    for (const Eigen::VectorXd& x : places) settings.push_back(setting(causes, x));
    std::vector<Outputs> all = model_.predict_each(settings, extent);
    for (Outputs& outputs : all)
        if (outputs.empty())
            for (const Experiment& experiment : experiments())
                outputs.emplace_back(experiment.size(), std::numeric_limits<double>::quiet_NaN());
    return all;
}

Outputs Problem::predict(const Causes& causes, const Eigen::VectorXd& x, Extent extent) const {
    return std::move(predict_each(causes, {x}, extent).front());
}

namespace {

constexpr std::size_t kTogether = 4;  ///< predictions

/// Calls body(from, to) for each group of up to `of` out of `count`, on `jobs` threads.
template <class Body>
void for_groups(std::size_t count, std::size_t of, unsigned jobs, const Body& body) {
    core::parallel_for((count + of - 1) / of, jobs, [&](std::size_t group) { body(group * of, std::min(count, (group + 1) * of)); });
}

}  // namespace

std::vector<Eigen::VectorXd> Problem::thin_residuals(const Causes& causes, const std::vector<Eigen::VectorXd>& places,
                                                     unsigned jobs) const {
    std::vector<Eigen::VectorXd> all(places.size());
    for_groups(places.size(), kTogether, jobs, [&](std::size_t from, std::size_t to) {
        const auto begin = places.begin();
        const std::vector<Eigen::VectorXd> group(begin + static_cast<std::ptrdiff_t>(from), begin + static_cast<std::ptrdiff_t>(to));
        const std::vector<Outputs> seen = predict_each(causes, group, Extent::kOncePerSetPoint);
        for (std::size_t i = from; i < to; ++i) all[i] = residual(seen[i - from]);
    });
    return all;
}

Eigen::VectorXd Problem::residual(const Outputs& prediction) const {
    Eigen::VectorXd r(rows_);
    int next = 0;
    for (std::size_t e = 0; e < experiments().size(); ++e) {
        const Experiment& experiment = experiments()[e];
        for (std::size_t i = 0; i < experiment.size(); ++i) r[next++] = (experiment.measured[i] - prediction[e][i]) / experiment.sigma[i];
    }
    return r;
}

Eigen::VectorXd Problem::direct_residual(const Causes& causes, const Eigen::VectorXd& x) const {
    Outputs outputs = predict(causes, x, Extent::kDirect);
    for (std::size_t e = 0; e < experiments().size(); ++e)
        if (!experiments()[e].direct) outputs[e] = experiments()[e].measured;
    return residual(outputs);
}

double Problem::step_of(const Causes& causes, int parameter) const {
    const bool tolerance = role(causes, parameter) == Role::kBuild && build()[static_cast<std::size_t>(parameter)].stated;
    return tolerance ? kStep : kEffectStep;
}

bool Problem::slopes_hold_between(const Causes& causes, const Eigen::VectorXd& at, const Eigen::VectorXd& x) const {
    if (at.size() == 0 || at.size() != x.size()) return false;
    for (int k = 0; k < x.size(); ++k)
        if (!(std::abs(x[k] - at[k]) <= step_of(causes, k))) return false;
    return true;
}

void Problem::renew(HeldSlopes& held, const Causes& causes, const Eigen::VectorXd& x, unsigned jobs) const {
    if (slopes_hold(held.at, x)) return;
    held.at = x.head(held.at.size());
    std::vector<Eigen::VectorXd> places(static_cast<std::size_t>(held.at.size()), x);
    std::vector<double> steps;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const int k = static_cast<int>(i);
        const double step = step_of(causes, k);
        steps.push_back(x[k] + step <= allowed(causes, k).high ? step : -step);
        places[i][k] += steps.back();
    }
    places.push_back(x);  // known: a fit has come from there
    const std::vector<Eigen::VectorXd> seen = thin_residuals(causes, places, jobs);
    for (std::size_t i = 0; i < steps.size(); ++i) held.slopes.col(static_cast<Eigen::Index>(i)) = (seen[i] - seen.back()) / steps[i];
}

Eigen::MatrixXd Problem::slopes(const Causes& causes, const Eigen::VectorXd& x, Eigen::Index first, Eigen::Index last, unsigned jobs,
                                Eigen::VectorXd* here) const {
    std::vector<Eigen::VectorXd> places;  // of each column the lower and the upper one
    for (Eigen::Index k = first; k < last; ++k) {
        const double step = step_of(causes, static_cast<int>(k));
        const core::Range range = allowed(causes, static_cast<int>(k));
        places.insert(places.end(), 2, x);
        places.end()[-2][k] = std::max(range.low, x[k] - step);
        places.back()[k] = std::min(range.high, x[k] + step);
    }
    if (has_figures_ || here != nullptr) places.push_back(x);  // it takes the place of a step that the simulator refuses
    const std::vector<Eigen::VectorXd> seen = thin_residuals(causes, places, jobs);
    if (here != nullptr) *here = seen.back();
    const auto told = [&](std::size_t place) { return has_figures_ && !seen[place].allFinite() ? seen.size() - 1 : place; };
    Eigen::MatrixXd columns(rows_, last - first);
    for (Eigen::Index k = first; k < last; ++k) {
        const std::size_t low = told(2 * static_cast<std::size_t>(k - first)), high = told(2 * static_cast<std::size_t>(k - first) + 1);
        columns.col(k - first) = (seen[high] - seen[low]) / (places[high][k] - places[low][k]);
    }
    return columns;
}

}  // namespace fusee::inference
