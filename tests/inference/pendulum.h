#pragma once
#include <cmath>
#include <random>

#include "fusee/inference/model.h"

namespace fusee::fixtures {

/// A pendulum of one metre as a model that is no joint: J q'' = -m g l sin q - c q', m l^2 = J. Effects: drag at its pivot, an encoder
/// that is turned, and a bob that cannot be built (the model refuses it).
class Pendulum final : public inference::Model {
public:
    static constexpr double kDragScale = 0.05, kOffsetScale = 0.05, kNoise = 2e-3, kLengthSigma = 3e-3;

    /// Measures a pendulum with these figures.
    Pendulum(double drag, double offset, double longer, unsigned seed) {
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal(0.0, kNoise);
        const char* names[] = {"hang", "swing", "fall"};
        for (const double start : {0.0, 0.4, 2.5}) {
            inference::Experiment& own = experiments_.emplace_back();
            own.name = names[experiments_.size() - 1];
            own.variable = "t_s";
            own.outputs = {"q_rad"};
            own.direct = start == 0.0;
            own.measured = angles(experiments_.size() - 1, longer, drag, offset);
            own.rows = own.measured.size();
            for (std::size_t i = 0; i < own.rows; ++i) {
                own.measured[i] += normal(random);
                own.sigma.push_back(kNoise);
                own.places.push_back({kRow * static_cast<double>(i), "q_rad", "q_rad", static_cast<int>(i / 10)});
            }
        }
        effects_.push_back({"pivot.drag", "c q'", {"none"}, {{"c", "Nms", kDragScale, {0.0, 2.0}, 0.0}}, {0.5, 2.0}, {1, 2}, {}});
        effects_.push_back(
            {"encoder.offset", "q + q_0", {"none"}, {{"q_0", "rad", kOffsetScale, {-1.0, 1.0}, 0.0}}, {1.0, -1.0}, {0, 1, 2}, {}});
        effects_.push_back({"bob.hollow", "none", {"none"}, {{"h", "1", 1.0, {-1.0, 1.0}, 0.0}}, {1.0}, {1}, {}});
    }
    [[nodiscard]] const std::vector<inference::Experiment>& experiments() const override { return experiments_; }
    [[nodiscard]] const std::vector<inference::BuildParameter>& build() const override { return build_; }
    [[nodiscard]] const std::vector<inference::Effect>& effects() const override { return effects_; }
    [[nodiscard]] inference::Outputs predict(const inference::Setting& setting, inference::Extent extent) const override {
        double drag = 0.0, offset = 0.0;
        for (const auto& [cause, values] : setting.effects) {
            if (cause.id == "bob.hollow") throw inference::Refusal("no such bob");
            (cause.id == "pivot.drag" ? drag : offset) = values.front();
        }
        inference::Outputs outputs(experiments_.size());
        for (std::size_t e = 0; e < outputs.size(); ++e)
            if (extent != inference::Extent::kDirect || experiments_[e].direct) outputs[e] = angles(e, setting.build.front(), drag, offset);
        return outputs;
    }

private:
    static constexpr double kRow = 0.05;  // [s]
    [[nodiscard]] static std::vector<double> angles(std::size_t experiment, double longer, double drag, double offset) {
        constexpr int kRows = 80, kSteps = 5;
        constexpr double kStart[] = {0.0, 0.4, 2.5}, kMass = 1.0, kGravity = 9.81;
        const double length = 1.0 + longer, inertia = kMass * length * length, h = kRow / kSteps;
        const auto turn = [&](double q, double v) { return (-kMass * kGravity * length * std::sin(q) - drag * v) / inertia; };
        double q = kStart[experiment], v = 0.0;
        std::vector<double> all;
        for (int i = 0; i < kRows; ++i) {
            all.push_back(q + offset);
            for (int k = 0; k < kSteps; ++k) {  // the midpoint rule
                const double half_q = q + 0.5 * h * v, half_v = v + 0.5 * h * turn(q, v);
                q += h * half_v;
                v += h * turn(half_q, half_v);
            }
        }
        return all;
    }

    std::vector<inference::Experiment> experiments_;
    std::vector<inference::BuildParameter> build_{{"length", "m", kLengthSigma, 1.0}};
    std::vector<inference::Effect> effects_;
};

}  // namespace fusee::fixtures
