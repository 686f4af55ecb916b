#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "fusee/core/error.h"
#include "law.h"

namespace fusee::subsystem {

namespace {

constexpr double kScatter = 0.03;        // relative, of the friction, where neither [sensors] nor repeats tell it
constexpr double kEnoughRepeats = 10.0;  // degrees of freedom of a scatter
constexpr double kMostMu = 0.95;         // spring::FrictionLaw allows no more
constexpr std::size_t kLeastLevels = 3;  // motor torques that can be held out one by one

struct MotorTerm {
    enum Type : std::size_t { kConstant, kAsymmetry, kQuadratic, kScale, kTerms };
};

struct Row {
    std::size_t side;
    double sign, motor;  // +1 backdrive
};

class MotorBreakaway final : public Law {
public:
    MotorBreakaway(const Case& subsystem_case, bool for_inputs);
    void predict(std::size_t record, const Values& values, std::vector<double>& predicted) const override;
    [[nodiscard]] diagnosis::NextExperiment next() const override;
    [[nodiscard]] std::vector<std::string> remarks() const override {
        return {
            "a gear with different friction in its two directions and a motor with a wrong torque scale give the same rows in any "
            "break-away test"};
    }

private:
    /// Where the term's number for a side stands; side = sides: for both.
    [[nodiscard]] std::size_t at(MotorTerm::Type term, std::size_t side) const { return sides_.size() + term * (sides_.size() + 1) + side; }
    [[nodiscard]] double term(const Values& values, MotorTerm::Type t, std::size_t side) const {
        return values[at(t, side)] + values[at(t, sides_.size())];
    }
    void set_parameters(const Case& subsystem_case);
    void set_targets(const Case& subsystem_case);
    void set_blocks();

    std::vector<std::string> sides_;
    std::vector<std::vector<Row>> rows_;
    double most_torque_ = 1e-9;
};

MotorBreakaway::MotorBreakaway(const Case& subsystem_case, bool for_inputs) {
    measured_name = "load_torque_Nm";
    region_name = "motor_torque_Nm";
    unit = "Nm";
    exact = true;
    same_rows = {"gear.asymmetry", "sensor.torque_scale"};
    std::set<std::string> names;
    for (const Record& record : subsystem_case.records)
        for (const std::string& side : record.texts.at("side")) names.insert(side);
    sides_.assign(names.begin(), names.end());
    if (sides_.size() > 2) throw core::InvalidInput("side", fmt::format("{} different names", sides_.size()), "one motor or two");
    for (const Record& record : subsystem_case.records) {
        const auto &side = record.texts.at("side"), &direction = record.texts.at("direction");
        const std::vector<double>& motor = record.columns.at("motor_torque_Nm");
        std::vector<Row> rows;
        for (std::size_t i = 0; i < motor.size(); ++i) {
            rows.push_back({side[i] == sides_.front() ? 0u : 1u, direction[i] == "backdrive" ? 1.0 : -1.0, motor[i]});
            most_torque_ = std::max(most_torque_, motor[i]);
        }
        rows_.push_back(std::move(rows));
    }
    set_parameters(subsystem_case);
    if (for_inputs) return;
    set_targets(subsystem_case);
    set_blocks();
}

void MotorBreakaway::set_parameters(const Case& subsystem_case) {
    const double friction = number_or(subsystem_case.parameters, "gear_load_friction", 0.2);
    for (const std::string& side : sides_) parameters.push_back({"gear_load_friction " + side, "", friction, 0.0, kMostMu, {}});
    nominal = sides_.size();
    // starts: the usual sizes; of asymmetry and scale those that change the rows as much, since they give the same rows
    const Parameter kinds[MotorTerm::kTerms] = {{"constant", "Nm", 0.0, -0.5 * most_torque_, most_torque_, {0.02 * most_torque_}},
                                                {"asymmetry", "", 0.0, -0.9, 0.9, {0.15}},
                                                {"quadratic", "1/Nm", 0.0, -0.5 / most_torque_, 0.5 / most_torque_, {0.1 / most_torque_}},
                                                {"scale", "", 0.0, -0.5, 1.0, {0.05}}};
    const char* ids[MotorTerm::kTerms] = {"gear.coulomb", "gear.asymmetry", "gear.load_quadratic", "sensor.torque_scale"};
    for (std::size_t t = 0; t < MotorTerm::kTerms; ++t)
        for (std::size_t s = 0; s <= sides_.size(); ++s) {
            parameters.push_back(kinds[t]);
            if (s == sides_.size() && s == 1) continue;  // one motor: no "both"
            effects.push_back({{ids[t], s < sides_.size() ? sides_[s] : "both"}, {at(static_cast<MotorTerm::Type>(t), s)}, false, ""});
        }
}

/// Sigma of a load from the friction met in the row's repeats (side, direction, motor torque): dL = f d/(1 - s mu), and the sensor's noise.
void MotorBreakaway::set_targets(const Case& subsystem_case) {
    const double noise = number_or(subsystem_case.sensors, "torque_noise_Nm", 0.0),
                 relative = number_or(subsystem_case.sensors, "torque_noise_relative", 0.0);
    std::map<std::tuple<std::size_t, double, double>, std::vector<double>> repeats;
    for (std::size_t r = 0; r < rows_.size(); ++r)
        for (std::size_t i = 0; i < rows_[r].size(); ++i)
            repeats[{rows_[r][i].side, rows_[r][i].sign, rows_[r][i].motor}].push_back(
                rows_[r][i].sign * (subsystem_case.records[r].columns.at("load_torque_Nm")[i] - rows_[r][i].motor));
    std::map<std::tuple<std::size_t, double, double>, double> friction;
    double squares = 0.0, freedom = 0.0;
    for (const auto& [key, met] : repeats) {
        double mean = 0.0;
        for (const double f : met) mean += f / static_cast<double>(met.size());
        friction[key] = std::max(std::abs(mean), 1e-3 * most_torque_);
        for (const double f : met) squares += std::pow((f - mean) / friction[key], 2);
        freedom += static_cast<double>(met.size()) - 1.0;
    }
    const bool given = subsystem_case.sensors.contains("breakaway_scatter"), repeated = freedom >= kEnoughRepeats;
    const double scatter = given ? subsystem_case.sensors.at("breakaway_scatter") : repeated ? std::sqrt(squares / freedom) : kScatter;
    if (!given && !repeated)
        default_sigma = fmt::format("sensors.breakaway_scatter is not given, and no {:g} repeats show it: {:g} of the friction is taken",
                                    kEnoughRepeats, kScatter);
    unit_sigma = 0.0;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        Target target{subsystem_case.records[r].columns.at("load_torque_Nm"),
                      {},
                      {},
                      subsystem_case.records[r].columns.at("motor_torque_Nm"),
                      "breakaway"};
        for (std::size_t i = 0; i < rows_[r].size(); ++i) {
            const Row& row = rows_[r][i];
            const double f = friction[{row.side, row.sign, row.motor}], load = target.measured[i];
            const double slope = std::min(0.9, f / std::max(load, 1e-3 * most_torque_));  // f' of friction in proportion to the load
            const double late = scatter * f / (1.0 - row.sign * slope);
            target.sigma.push_back(std::max(1e-9, std::hypot(late, noise, relative * load)));
            unit_sigma = std::max(unit_sigma, target.sigma.back());
        }
        targets.push_back(std::move(target));
    }
    floor_remarks.push_back(fmt::format("sigma is a scatter of {:.3g} of the friction{} and the torque sensor's noise", scatter,
                                        given      ? ""
                                        : repeated ? " (from the repeats)"
                                                   : " (a default: no sensors.breakaway_scatter is given)"));
}

/// A motor torque is held out as a whole; with fewer than three of them, every third row.
void MotorBreakaway::set_blocks() {
    std::set<double> levels;
    for (const auto& rows : rows_)
        for (const Row& row : rows) levels.insert(row.motor);
    const bool by_level = levels.size() >= kLeastLevels;
    std::map<std::pair<std::size_t, std::string>, std::vector<std::size_t>> members;
    for (std::size_t r = 0; r < rows_.size(); ++r)
        for (std::size_t i = 0; i < rows_[r].size(); ++i)
            members[{r, by_level ? fmt::format("motor_torque {:g} Nm", rows_[r][i].motor) : fmt::format("part {}", i % 3 + 1)}].push_back(
                i);
    for (const auto& [key, rows] : members) blocks.push_back({key.second, key.first, rows});
}

/// L - s f(L) = k tau_m with f = c + mu (1 + s a) L + b L^2 (docs/subsystem-cases.md, eq. 7): the smaller root, Newton from below.
void MotorBreakaway::predict(std::size_t record, const Values& values, std::vector<double>& predicted) const {
    predicted.resize(rows_[record].size());
    for (std::size_t i = 0; i < predicted.size(); ++i) {
        const auto& [side, s, motor] = rows_[record][i];
        const double c = term(values, MotorTerm::kConstant, side), b = term(values, MotorTerm::kQuadratic, side),
                     k = 1.0 + term(values, MotorTerm::kScale, side);
        const double mu = std::clamp(values[side] * (1.0 + s * term(values, MotorTerm::kAsymmetry, side)), 0.0, kMostMu);
        double load = (k * motor + s * c) / (1.0 - s * mu);
        for (int step = 0; step < 6; ++step)
            load -= (load - s * (c + mu * load + b * load * load) - k * motor) / std::max(0.05, 1.0 - s * (mu + 2.0 * b * load));
        predicted[i] = std::max(0.0, load);
    }
}

diagnosis::NextExperiment MotorBreakaway::next() const {
    diagnosis::NextExperiment next;
    next.experiment = "breakaway";
    next.variable = "motor_torque_Nm";
    next.set_points = {0.05 * most_torque_, 0.25 * most_torque_, 0.5 * most_torque_, most_torque_, 1.5 * most_torque_};
    next.cost = 12.0;
    next.text = fmt::format(
        "break-away both ways at {:.3g}, {:.3g}, {:.3g}, {:.3g} and {:.3g} Nm, three repeats each: low torques show a constant, high ones "
        "a "
        "curvature; the motor's torque against a lever and a weight, the gear taken off, tells a torque scale from a gear whose directions "
        "differ",
        next.set_points[0], next.set_points[1], next.set_points[2], next.set_points[3], next.set_points[4]);
    return next;
}

}  // namespace

std::unique_ptr<Law> motor_breakaway(const Case& subsystem_case, bool for_inputs) {
    return std::make_unique<MotorBreakaway>(subsystem_case, for_inputs);
}

}  // namespace fusee::subsystem
