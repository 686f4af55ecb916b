#include "fusee/inference/problem.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/effects/term.h"

namespace fusee::inference {

namespace {

constexpr double kStep = 0.3;         ///< of a difference: in sigmas of a build parameter
constexpr double kEffectStep = 0.04;  ///< in scales of an effect's parameter

std::vector<effects::Effect> effects_and_terms(const gap_case::Reference& reference) {
    std::vector<effects::Effect> all = effects::effects_on(reference);
    for (effects::Effect& term : effects::terms_on(reference)) all.push_back(std::move(term));
    return all;
}

}  // namespace

Problem::Problem(const gap_case::Case& gap_case)
    : gap_case_(gap_case),
      library_(effects_and_terms(gap_case::reference_of(gap_case.rig))),
      cams_(gap_case.rig),
      build_(joint_model::build_parameters(gap_case)),
      known_(uncertainty(gap_case)),
      measured_(joint_model::measured(gap_case.rows)),
      thin_(gap_case.rows) {
    thin_.dead_band.clear();
    for (const gap_case::DeadBandRow& row : gap_case.rows.dead_band) {
        const auto same = std::find_if(thin_.dead_band.begin(), thin_.dead_band.end(),
                                       [&](const gap_case::DeadBandRow& other) { return other.cocontraction == row.cocontraction; });
        like_.push_back(static_cast<std::size_t>(same - thin_.dead_band.begin()));
        if (same == thin_.dead_band.end()) thin_.dead_band.push_back(row);
        thin_.dead_band[like_.back()].row = like_.size();
    }
    for (std::size_t e = 0; e < gap_case::kExperiments; ++e) {
        first_[e] = rows_;
        rows_ += static_cast<int>(measured_.of[e].size());
    }
    first_[gap_case::kExperiments] = rows_;
    root_weight_.resize(rows_);
    for (int i = 0; i < rows_; ++i) root_weight_[i] = std::sqrt(known_.weight[static_cast<int>(experiment_of(i))]);
}

int Problem::size(const Causes& causes) const {
    std::size_t n = build_.size();
    for (const effects::Cause& cause : causes) n += effect(cause.id).parameters.size();
    return static_cast<int>(n);
}

gap_case::Experiment Problem::experiment_of(int residual) const {
    std::size_t e = 0;
    while (residual >= first_[e + 1]) ++e;
    return static_cast<gap_case::Experiment>(e);
}

const effects::Effect& Problem::effect(const std::string& id) const {
    const auto found = std::find_if(library_.begin(), library_.end(), [&](const effects::Effect& effect) { return effect.id == id; });
    return found == library_.end() ? effects::find_effect(id) : *found;
}

/// Calls visit(effect, number of its parameter, index in x) for the parameters of all causes.
template <typename Visit>
void Problem::visit_parameters(const Causes& causes, const Visit& visit) const {
    std::size_t first = build_.size();
    for (const effects::Cause& cause : causes) {
        const effects::Effect& own = effect(cause.id);
        for (std::size_t k = 0; k < own.parameters.size(); ++k) visit(own, k, static_cast<int>(first++));
    }
}

core::Range Problem::allowed(const Causes& causes, int parameter) const {
    core::Range range{-8.0, 8.0};
    visit_parameters(causes, [&](const effects::Effect& effect, std::size_t k, int i) {
        const effects::EffectParameter& p = effect.parameters[k];
        if (i == parameter) range = {p.allowed.low / p.scale, p.allowed.high / p.scale};
    });
    return range;
}

Eigen::VectorXd Problem::start(const Causes& causes) const {
    Eigen::VectorXd x = prior_mean(causes);
    visit_parameters(causes, [&](const effects::Effect& effect, std::size_t k, int i) {
        if (k == 0) x[i] = effect.starts.front();
    });
    return x;
}

Eigen::VectorXd Problem::prior_mean(const Causes& causes) const {
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(size(causes));
    visit_parameters(causes, [&](const effects::Effect& effect, std::size_t k, int i) {
        if (k > 0) mean[i] = effect.parameters[k].at_first / effect.parameters[k].scale;
    });
    return mean;
}

int Problem::size_at(const Causes& causes, std::size_t cause) const {
    return size(Causes(causes.begin(), causes.begin() + static_cast<std::ptrdiff_t>(cause)));
}

Eigen::VectorXd Problem::without_others(const Causes& causes, const Eigen::VectorXd& x, const effects::Cause& kept) const {
    Eigen::VectorXd own(size({kept}));
    const auto build = static_cast<Eigen::Index>(build_.size());
    own.head(build) = x.head(build);
    const auto at = static_cast<std::size_t>(std::find(causes.begin(), causes.end(), kept) - causes.begin());
    own.tail(own.size() - build) = x.segment(size_at(causes, at), own.size() - build);
    return own;
}

Eigen::VectorXd Problem::with_positive_ripples(const Causes& causes, Eigen::VectorXd x) const {
    for (std::size_t c = 0; c < causes.size(); ++c) {
        const effects::Effect& own = effect(causes[c].id);
        if (!own.has_phase()) continue;
        double& amplitude = x[size_at(causes, c)];
        double& phase = x[size_at(causes, c + 1) - 1];
        const double scale = own.parameters.back().scale, turned = scale * phase + (amplitude < 0.0 ? core::kPi : 0.0);
        phase = std::remainder(turned, 2.0 * core::kPi) / scale;
        amplitude = std::abs(amplitude);
    }
    return x;
}

double Problem::prior_sigma(const Causes& causes, int parameter) const {
    return role(causes, parameter) == Role::kSize ? kEffectPrior : 1.0;
}

Problem::Role Problem::role(const Causes& causes, int parameter) const {
    Role role = Role::kBuild;
    visit_parameters(causes, [&](const effects::Effect& effect, std::size_t k, int i) {
        if (i != parameter) return;
        role = k == 0 ? Role::kSize : Role::kFurther;
        if (k > 0 && effect.has_phase()) role = k + 1 == effect.parameters.size() ? Role::kPhase : Role::kCount;
    });
    return role;
}

joint_model::BuiltRig Problem::rig(const Causes& causes, const Eigen::VectorXd& x) const {
    joint_model::BuiltRig rig(gap_case_.rig);
    for (std::size_t i = 0; i < build_.size(); ++i) build_[i].add(rig, x[static_cast<int>(i)] * build_[i].sigma);
    auto next = static_cast<int>(build_.size());
    for (const effects::Cause& cause : causes) {
        const effects::Effect& own = effect(cause.id);
        std::vector<double> values;
        for (const effects::EffectParameter& p : own.parameters)
            values.push_back(std::clamp(x[next++] * p.scale, p.allowed.low, p.allowed.high));
        effects::apply_effect(own, cause, values, rig);
    }
    rig.assemble(cams_);
    return rig;
}

joint_model::Signals Problem::predict(const Causes& causes, const Eigen::VectorXd& x) const {
    return joint_model::predict_signals(rig(causes, x), gap_case_.rows, gap_case_.protocol);
}

joint_model::Signals Problem::predict_thin(const Causes& causes, const Eigen::VectorXd& x) const {
    joint_model::Signals signals = joint_model::predict_signals(rig(causes, x), thin_, gap_case_.protocol);
    const std::vector<double> levels = signals[gap_case::Experiment::kDeadBand];
    const std::size_t columns = thin_.dead_band_width_only ? 1 : 2;
    std::vector<double>& all = signals[gap_case::Experiment::kDeadBand];
    all.clear();
    for (const std::size_t level : like_)
        for (std::size_t c = 0; c < columns; ++c) all.push_back(levels[level * columns + c]);
    return signals;
}

Eigen::VectorXd Problem::residual(const joint_model::Signals& prediction) const {
    Eigen::VectorXd r(rows_);
    int next = 0;
    for (std::size_t e = 0; e < gap_case::kExperiments; ++e)
        for (std::size_t i = 0; i < measured_.of[e].size(); ++i)
            r[next++] = (measured_.of[e][i] - prediction.of[e][i]) / known_.sigma.of[e][i];
    return r;
}

Eigen::VectorXd Problem::direct_residual(const Causes& causes, const Eigen::VectorXd& x) const {
    const joint_model::BuiltRig built = rig(causes, x);
    joint_model::Signals signals = measured_;
    for (const gap_case::Experiment experiment : {gap_case::Experiment::kBreakAway, gap_case::Experiment::kSpringPull})
        signals[experiment] = joint_model::predict_experiment(built, gap_case_.rows, gap_case_.protocol, experiment);
    return residual(signals);
}

Eigen::VectorXd Problem::slope(const Causes& causes, const Eigen::VectorXd& x, int parameter) const {
    const double step = role(causes, parameter) == Role::kBuild ? kStep : kEffectStep;
    const core::Range range = allowed(causes, parameter);
    Eigen::VectorXd low = x, high = x;
    low[parameter] = std::max(range.low, x[parameter] - step);
    high[parameter] = std::min(range.high, x[parameter] + step);
    return (thin_residual(causes, high) - thin_residual(causes, low)) / (high[parameter] - low[parameter]);
}

}  // namespace fusee::inference
