#include "changed_law.h"

#include <algorithm>
#include <cmath>

namespace fusee::search::one_spring {

namespace {

constexpr std::size_t kEvery = 8;  // of the samples of a task, a point of a law: 101

/// The torques under a Gaussian; beyond both ends they go on point-symmetrically, so that the ends stay.
std::vector<double> smoothed(const std::vector<double>& torques, double width) {
    constexpr double kReach = 3.5, kLeast = 0.1;  // of the standard deviation in samples
    const auto last = static_cast<std::ptrdiff_t>(torques.size()) - 1;
    const double sigma = width * static_cast<double>(last);
    if (!(sigma > kLeast)) return torques;
    const std::ptrdiff_t reach = std::min(last, static_cast<std::ptrdiff_t>(kReach * sigma));
    const auto given = [&](std::ptrdiff_t i) { return torques[static_cast<std::size_t>(i)]; };
    const auto at = [&](std::ptrdiff_t i) {
        if (i < 0) return 2.0 * given(0) - given(-i);
        return i > last ? 2.0 * given(last) - given(2 * last - i) : given(i);
    };
    std::vector<double> weights;
    for (std::ptrdiff_t k = 0; k <= reach; ++k) weights.push_back(std::exp(-0.5 * std::pow(static_cast<double>(k) / sigma, 2)));
    std::vector<double> all;
    for (std::ptrdiff_t i = 0; i <= last; ++i) {
        double sum = given(i), total = 1.0;
        for (std::ptrdiff_t k = 1; k <= reach; ++k) {
            const double weight = weights[static_cast<std::size_t>(k)];
            sum += weight * (at(i - k) + at(i + k));
            total += 2.0 * weight;
        }
        all.push_back(sum / total);
    }
    return all;
}

/// As many torques, evenly over the first `share` of the travel.
std::vector<double> beginning(const std::vector<double>& torques, double share) {
    std::vector<double> all;
    for (std::size_t i = 0; i < torques.size(); ++i) {
        const double at = share * static_cast<double>(i);
        const auto before = std::min(static_cast<std::size_t>(at), torques.size() - 2);
        all.push_back(std::lerp(torques[before], torques[before + 1], at - static_cast<double>(before)));
    }
    return all;
}

}  // namespace

std::vector<double> points_of(const Task& task) {
    std::vector<double> points;
    for (std::size_t i = 0; i < task.torques.size(); i += kEvery) points.push_back(task.torques[i]);
    return points;
}

profile::Profile with_law(profile::Profile p, const Task& task, const std::vector<double>& points) {
    auto& law = std::get<profile::OneSpring>(p.law.curves);
    const double first = law.first_angle(), step = task.travel / static_cast<double>(points.size() - 1);
    law.rows = {};
    for (std::size_t i = 0; i < points.size(); ++i) law.rows.x.push_back(first + static_cast<double>(i) * step);
    law.rows.y = points;
    law.kind = profile::OneSpring::Kind::kPoints;
    p.columns = {};
    return p;
}

Task changed_task(const Task& task, const Draft& draft) {
    Task now;
    now.travel = draft.kept * task.travel;
    now.torques = smoothed(beginning(task.torques, draft.kept), draft.width);
    const double step = now.travel / static_cast<double>(now.torques.size() - 1);
    double energy = 0.0, before = 0.0;  // by the trapezoids under the torques
    for (std::size_t i = 0; i < now.torques.size(); ++i) {
        double& torque = now.torques[i];
        torque *= draft.share;
        if (i > 0) energy += 0.5 * step * (torque + before);
        before = torque;
        now.torque = std::max(now.torque, std::abs(torque));
        now.of_first = {std::min(now.of_first.low, energy), std::max(now.of_first.high, energy)};
    }
    return now;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) squares += std::pow(a[i] - b[i], 2) * (i == 0 || i + 1 == a.size() ? 0.5 : 1.0);
    return std::sqrt(squares / static_cast<double>(a.size() - 1));
}

}  // namespace fusee::search::one_spring
