#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "cycles.h"
#include "fusee/core/error.h"
#include "law.h"

namespace fusee::subsystem {

namespace {

/// Spring, play and slider in series (docs/subsystem-cases.md, eq. 1 to 3): u is the elongation of spring and play.
struct ElementParameter {
    enum : std::size_t { kCoulomb, kDeflection, kBacklash, kSeat, kAsymmetry, kViscous, kStribeck, kStribeckSpeed, kLoad, kPlaces };
};

constexpr double kRigid = 1e-7;     // [m], elastic deflection of an element without presliding
constexpr double kRigidPlay = 0.1;  // the same with play, of a row's travel: a fit then sees which way to go

struct Drive {
    std::vector<double> x, speed;
    double preload = 0.0;  // [N]
    double rigid = 0.0;    // [m]
};

class FrictionElement final : public Law {
public:
    FrictionElement(const Case& subsystem_case, bool for_inputs);
    void predict(std::size_t record, const Values& values, std::vector<double>& predicted) const override;
    [[nodiscard]] diagnosis::NextExperiment next() const override;

private:
    void set_parameters(const Case& subsystem_case, double force);
    void set_targets(const Case& subsystem_case, std::size_t thin);
    void set_floors(const Case& subsystem_case);
    void set_preloads(const Case& subsystem_case);

    std::vector<Drive> drives_;
    std::vector<Cycles> cycles_;
    double amplitude_ = 0.0, speed_ = 0.0;  // the largest of all files
    double preload_ = 1.0;                  // mean over the files [N]
    bool preloads_differ_ = false;
};

/// Speed as measured, or central differences of the displacement.
std::vector<double> speed_of(const Record& record) {
    if (const auto v = record.columns.find("v_m_s"); v != record.columns.end()) return v->second;
    const std::vector<double>&t = record.columns.at("t_s"), &x = record.columns.at("x_m");
    std::vector<double> speed(x.size(), 0.0);
    for (std::size_t i = 1; i + 1 < x.size(); ++i) speed[i] = (x[i + 1] - x[i - 1]) / (t[i + 1] - t[i - 1]);
    return speed;
}

double mean_travel(const std::vector<double>& x) {
    double travel = 0.0;
    for (std::size_t i = 1; i < x.size(); ++i) travel += std::abs(x[i] - x[i - 1]);
    return std::max(1e-12, travel / static_cast<double>(x.size()));
}

/// Travel since the last reversal that was followed by more than a hundredth of the amplitude.
std::vector<double> travel_since_reversal(const std::vector<double>& x, double amplitude) {
    std::vector<double> travel;
    double turn = x.front(), farthest = x.front(), sign = 0.0;
    for (const double at : x) {
        if (sign != 0.0 && sign * (at - farthest) >= 0.0) farthest = at;
        if (std::abs(at - farthest) > 0.01 * amplitude) {
            turn = farthest;
            sign = at > farthest ? 1.0 : -1.0;
            farthest = at;
        }
        travel.push_back(std::abs(at - turn));
    }
    return travel;
}

FrictionElement::FrictionElement(const Case& subsystem_case, bool for_inputs) {
    measured_name = "F_N";
    region_name = "travel_since_reversal_m";
    unit = "N";
    const std::size_t thin = for_inputs ? 1 : thinning(subsystem_case.records);
    set_preloads(subsystem_case);
    for (std::size_t r = 0; r < subsystem_case.records.size(); ++r) {
        drives_[r].x = every(subsystem_case.records[r].columns.at("x_m"), thin);
        drives_[r].speed = every(speed_of(subsystem_case.records[r]), thin);
        drives_[r].rigid = kRigidPlay * mean_travel(drives_[r].x);
        const auto [low, high] = std::minmax_element(drives_[r].x.begin(), drives_[r].x.end());
        amplitude_ = std::max(amplitude_, 0.5 * (*high - *low));
        for (const double v : drives_[r].speed) speed_ = std::max(speed_, std::abs(v));
    }
    if (!for_inputs) {
        set_floors(subsystem_case);
        set_targets(subsystem_case, thin);
    }
    double force = 1.0;
    for (const Target& target : targets)
        for (const double f : target.measured) force = std::max(force, std::abs(f));
    set_parameters(subsystem_case, force);
    if (for_inputs) return;
    if (!(amplitude_ > 0.0)) throw core::InvalidInput("x_m", "no motion in any file", "an element that is driven back and forth");
    if (thin > 1) floor_remarks.push_back(fmt::format("the fits use every {}th row; the floors use all rows", thin));
    floor_remarks.push_back("rows before the first whole cycle are not judged: the deflection of the element at the start is unknown");
    make_blocks(*this, subsystem_case);
    std::vector<std::string> amplitudes, frequencies;
    for (const Cycles& cycles : cycles_) {
        amplitudes.push_back(fmt::format("{:.2g} m", first_of_same_amplitude(cycles_, cycles).amplitude));
        frequencies.push_back(cycles.period > 0.0 ? fmt::format("{:.2g} Hz", 1.0 / cycles.period) : "aperiodic");
    }
    add_scheme(*this, "amplitude", amplitudes);
    add_scheme(*this, "frequency", frequencies);
    for (std::size_t r = 0; r < targets.size(); ++r) targets[r].group = fmt::format("force_loop, amplitude {}", amplitudes[r]);
}

void FrictionElement::set_preloads(const Case& subsystem_case) {
    drives_.resize(subsystem_case.records.size());
    std::vector<double> preloads;
    for (const Record& record : subsystem_case.records)
        if (const auto at = record.parameters.find("preload_N"); at != record.parameters.end()) preloads.push_back(at->second);
    if (preloads.size() < subsystem_case.records.size()) return;
    const double mean = std::accumulate(preloads.begin(), preloads.end(), 0.0) / static_cast<double>(preloads.size());
    if (!(mean > 0.0)) return;
    for (std::size_t r = 0; r < drives_.size(); ++r) drives_[r].preload = preloads[r];
    preload_ = mean;
    const auto [low, high] = std::minmax_element(preloads.begin(), preloads.end());
    preloads_differ_ = *high - *low > 0.02 * mean;
}

void FrictionElement::set_parameters(const Case& subsystem_case, double force) {
    const double a = amplitude_;
    parameters.resize(ElementParameter::kPlaces);
    double sum = 0.0, given = 0.0;
    for (const Record& record : subsystem_case.records)
        if (const auto at = record.parameters.find("coulomb_N"); at != record.parameters.end()) sum += at->second, given += 1.0;
    const double start = given > 0.0 ? std::clamp(sum / given, 1e-3 * force, 10.0 * force) : 0.7 * force;
    parameters[ElementParameter::kCoulomb] = {"coulomb", "N", start, 1e-3 * force, 10.0 * force, {}};
    parameters[ElementParameter::kDeflection] = {"deflection", "m", 0.0, 0.0, a, {0.03 * a, 0.15 * a}};
    parameters[ElementParameter::kBacklash] = {"backlash", "m", 0.0, 0.0, a, {0.05 * a, 0.1 * a, 0.2 * a, 0.4 * a}};
    parameters[ElementParameter::kSeat] = {"seat", "", 0.0, 0.0, 1.0, {0.5}, 0.0, OwnEnds::kBoth};
    parameters[ElementParameter::kAsymmetry] = {"asymmetry", "", 0.0, -0.9, 0.9, {0.05}};
    parameters[ElementParameter::kViscous] = {"viscous", "Ns/m", 0.0, 0.0, 5.0 * force / speed_, {0.05 * force / speed_}};
    parameters[ElementParameter::kStribeck] = {"stribeck", "", 0.0, 0.0, 5.0, {0.1}};
    parameters[ElementParameter::kStribeckSpeed] = {"stribeck_speed", "m/s",  0.1 * speed_,
                                                    0.01 * speed_,    speed_, {0.05 * speed_, 0.3 * speed_}};
    parameters[ElementParameter::kLoad] = {"load", "", 0.0, -force / preload_, 2.0 * force / preload_, {0.2 * force / preload_}};
    nominal = 1;
    effects = {{{"element.presliding"}, {ElementParameter::kDeflection}, false, ""},
               {{"element.backlash"}, {ElementParameter::kBacklash, ElementParameter::kSeat}, false, ""},
               {{"element.asymmetry"}, {ElementParameter::kAsymmetry}, false, ""},
               {{"element.viscous"}, {ElementParameter::kViscous}, true, ""},
               {{"element.stribeck"}, {ElementParameter::kStribeck, ElementParameter::kStribeckSpeed}, true, ""},
               {{"element.load"}, {ElementParameter::kLoad}, true, ""}};
    if (!preloads_differ_) effects.back().unseen = "preload_N is not given, or the same in every file";
}

/// Sigma is the sensor's, or else the scatter from cycle to cycle.
void FrictionElement::set_floors(const Case& subsystem_case) {
    double squares = 0.0, freedom = 0.0;
    for (const Record& record : subsystem_case.records) {
        cycles_.push_back(find_cycles(record.columns.at("t_s"), record.columns.at("x_m"), record.columns.at("F_N")));
        squares += cycles_.back().variance * static_cast<double>(cycles_.back().freedom);
        freedom += static_cast<double>(cycles_.back().freedom);
    }
    const double cycle = freedom > 0.0 ? std::sqrt(squares / freedom) : 0.0, setup = std::sqrt(setup_variance(cycles_));
    const auto given = subsystem_case.sensors.find("force_noise_N");
    if (given == subsystem_case.sensors.end() && !(cycle > 0.0))
        throw core::InvalidInput("sensors.force_noise_N", "missing, and no input repeats a cycle",
                                 "a force noise, or files with repeated cycles");
    unit_sigma = given != subsystem_case.sensors.end() ? given->second : cycle;
    cycle_floor = std::max(1.0, cycle / unit_sigma);
    setup_floor = std::isfinite(setup) ? std::max(cycle_floor, setup / unit_sigma) : cycle_floor;
    if (given == subsystem_case.sensors.end())
        floor_remarks.push_back(
            fmt::format("sigma is the scatter from cycle to cycle, {:.4g} N: no sensors.force_noise_N is given", cycle));
    if (std::isfinite(setup))
        floor_remarks.push_back(
            fmt::format("files of the same amplitude differ by {:.4g} N: the floor from one set-up to the next", setup));
}

void FrictionElement::set_targets(const Case& subsystem_case, std::size_t thin) {
    for (std::size_t r = 0; r < subsystem_case.records.size(); ++r) {
        Target target;
        target.measured = every(subsystem_case.records[r].columns.at("F_N"), thin);
        target.sigma.assign(target.measured.size(), unit_sigma);
        target.region = travel_since_reversal(drives_[r].x, amplitude_);
        for (const double t : every(subsystem_case.records[r].columns.at("t_s"), thin))
            target.settled.push_back(cycles_[r].period <= 0.0 || t >= cycles_[r].begin);
        targets.push_back(std::move(target));
    }
}

/// Play whose flanks meet over a stretch of travel: what is left of the elongation u >= 0 for the spring, and its inverse.
struct Play {
    double free, seat;  // half of the travel without any force; half of the stretch over which the flanks come to bear

    [[nodiscard]] double stretch(double u) const {
        const double z = u - free;
        return z <= 0.0 ? 0.0 : z < 2.0 * seat ? z * z / (4.0 * seat) : z - seat;
    }
    [[nodiscard]] double elongation(double stretch) const {
        return free + (stretch < seat ? 2.0 * std::sqrt(seat * stretch) : stretch + seat);
    }
};

void FrictionElement::predict(std::size_t record, const Values& values, std::vector<double>& predicted) const {
    const Drive& drive = drives_[record];
    const Play play{0.5 * values[ElementParameter::kBacklash] * (1.0 - values[ElementParameter::kSeat]),
                    0.5 * values[ElementParameter::kBacklash] * values[ElementParameter::kSeat]};
    const double coulomb = std::max(1e-9, values[ElementParameter::kCoulomb] + values[ElementParameter::kLoad] * drive.preload);
    const double stiffness =
        coulomb / std::max(values[ElementParameter::kDeflection],
                           values[ElementParameter::kBacklash] > 0.0 ? drive.rigid : kRigid);  // of an even element, whatever the speed
    const bool speeds = values[ElementParameter::kViscous] != 0.0 || values[ElementParameter::kStribeck] != 0.0;
    predicted.resize(drive.x.size());
    double u = 0.0;
    for (std::size_t i = 0; i < drive.x.size(); ++i) {
        double most = coulomb;
        if (speeds) {
            const double v = drive.speed[i], ratio = v / values[ElementParameter::kStribeckSpeed];
            most = std::max(0.0, most * (1.0 + values[ElementParameter::kStribeck] * std::exp(-ratio * ratio)) +
                                     values[ElementParameter::kViscous] * std::abs(v));
        }
        if (i > 0) u += drive.x[i] - drive.x[i - 1];
        const double side = 1.0 + (u > 0.0 ? values[ElementParameter::kAsymmetry] : -values[ElementParameter::kAsymmetry]);
        const double elastic = stiffness * side * play.stretch(std::abs(u));
        const double limit = most * side;
        predicted[i] = std::copysign(std::min(elastic, limit), u);
        if (elastic > limit) u = std::copysign(play.elongation(limit / (stiffness * side)), u);  // the slider moves
    }
}

diagnosis::NextExperiment FrictionElement::next() const {
    diagnosis::NextExperiment next;
    next.experiment = "force_loop";
    next.variable = "x_m";
    next.set_points = {0.02 * amplitude_, 0.1 * amplitude_, amplitude_};
    next.cost = 10.0;
    next.text = fmt::format(
        "drive the element with triangles of {:.2g}, {:.2g} and {:.2g} m at one slow speed, twice each, with the element removed and "
        "mounted again in between: small triangles distinguish play from elastic deflection, the repeated set-up gives the floor{}",
        next.set_points[0], next.set_points[1], next.set_points[2],
        preloads_differ_ ? "" : "; then the same at another preload: this case cannot show a dependence on load");
    return next;
}

}  // namespace

std::unique_ptr<Law> friction_element(const Case& subsystem_case, bool for_inputs) {
    return std::make_unique<FrictionElement>(subsystem_case, for_inputs);
}

}  // namespace fusee::subsystem
