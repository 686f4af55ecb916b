#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "fusee/core/error.h"
#include "fusee/math/statistics.h"
#include "law.h"

namespace fusee::subsystem {

namespace {

/// Cycles of a periodic input, and the scatter of the measured column between them.
struct Cycles {
    double period = 0.0;       ///< [s]; 0: input not periodic, or fewer than two whole cycles
    double begin = 0.0;        ///< start of the first cycle in use [s]
    double amplitude = 0.0;    ///< half of the input's range
    std::vector<double> mean;  ///< the loop: mean of the measured column over the cycles, in kPhases bins of one cycle
    double variance = 0.0;     ///< of a row about the mean of its phase over the cycles, unbiased; 0 where there is one cycle only
    std::size_t freedom = 0;   ///< of `variance`: 0 where there is one cycle only
    static constexpr std::size_t kPhases = 64;
};

constexpr std::size_t kPhases = Cycles::kPhases;
constexpr double kLikePeriods = 0.05;     // relative; beyond it, the input is not periodic
constexpr double kLikeAmplitudes = 0.05;  // relative
constexpr double kMostSteps = 16.0;       // for each of the kPhases bins: 1024 rows of a cycle

/// Times at which the input rises through `middle`, after having been below it by a tenth of the amplitude.
std::vector<double> rises(const std::vector<double>& time, const std::vector<double>& input, double middle, double amplitude) {
    std::vector<double> at;
    bool below = false;
    for (std::size_t i = 1; i < input.size(); ++i) {
        if (input[i] < middle - 0.1 * amplitude) below = true;
        if (!below || input[i] < middle) continue;
        const double step = input[i] - input[i - 1];
        at.push_back(step > 0.0 ? time[i] - (time[i] - time[i - 1]) * (input[i] - middle) / step : time[i]);
        below = false;
    }
    return at;
}

/// One cycle, and how far the input went in it.
struct Span {
    double begin, end;
    double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
};

/// The spans with the usual duration and range: an input that begins from rest or decays has none.
std::vector<Span> usual_spans(std::vector<Span> spans) {
    if (spans.empty()) return spans;
    std::vector<double> lengths, ranges;
    for (const Span& s : spans) lengths.push_back(s.end - s.begin), ranges.push_back(s.high - s.low);
    const double length = math::upper_median(std::move(lengths)), range = math::upper_median(std::move(ranges));
    std::erase_if(spans, [&](const Span& s) {
        return std::abs(s.end - s.begin - length) > kLikePeriods * length || std::abs(s.high - s.low - range) > kLikeAmplitudes * range;
    });
    return spans;
}

double median_length(const std::vector<Span>& spans) {
    std::vector<double> lengths;
    for (const Span& s : spans) lengths.push_back(s.end - s.begin);
    return math::upper_median(std::move(lengths));
}

/// The measured column at `steps` even phases of one cycle, straight between rows.
std::vector<double> loop_of(const std::vector<double>& time, const std::vector<double>& measured, const Span& span, std::size_t steps) {
    std::vector<double> loop(steps);
    for (std::size_t i = 0; i < steps; ++i) {
        const double t = span.begin + (span.end - span.begin) * (static_cast<double>(i) + 0.5) / static_cast<double>(steps);
        const auto after = static_cast<std::size_t>(std::upper_bound(time.begin() + 1, time.end() - 1, t) - time.begin());
        const double share = (t - time[after - 1]) / (time[after] - time[after - 1]);
        loop[i] = (1.0 - share) * measured[after - 1] + share * measured[after];
    }
    return loop;
}

/// Cycles begin where the input rises through the middle of its range. Cycles that differ from most in duration or range (5 %) are left
/// out: an input that begins from rest and dies out at the end.
/// @pre all of one length, times ascending
Cycles find_cycles(const std::vector<double>& time, const std::vector<double>& input, const std::vector<double>& measured) {
    Cycles cycles;
    const auto [low, high] = std::minmax_element(input.begin(), input.end());
    cycles.amplitude = 0.5 * (*high - *low);
    const std::vector<double> at = rises(time, input, 0.5 * (*high + *low), cycles.amplitude);
    std::vector<Span> spans;
    for (std::size_t c = 0; c + 1 < at.size(); ++c) spans.push_back({at[c], at[c + 1]});
    for (std::size_t i = 0, c = 0; i < time.size() && c < spans.size(); ++i) {
        if (time[i] >= spans[c].end) ++c;
        if (c == spans.size() || time[i] < spans[c].begin) continue;
        spans[c].low = std::min(spans[c].low, input[i]);
        spans[c].high = std::max(spans[c].high, input[i]);
    }
    const std::size_t found = spans.size();
    spans = usual_spans(std::move(spans));
    if (spans.empty() || 2 * spans.size() < found) return cycles;
    cycles.begin = spans.front().begin;
    cycles.period = median_length(spans);
    const double rows = static_cast<double>(time.size()) * cycles.period / (time.back() - time.front());
    const auto steps = static_cast<std::size_t>(std::clamp(rows / kPhases, 1.0, kMostSteps)) * kPhases;
    std::vector<std::vector<double>> loops;
    for (const Span& span : spans) loops.push_back(loop_of(time, measured, span, steps));
    cycles.mean.assign(kPhases, 0.0);
    const double n = static_cast<double>(loops.size());
    for (std::size_t i = 0; i < steps; ++i) {
        double sum = 0.0, squares = 0.0;
        for (const auto& loop : loops) sum += loop[i];
        for (const auto& loop : loops) squares += std::pow(loop[i] - sum / n, 2);
        cycles.mean[i * kPhases / steps] += sum / n * static_cast<double>(kPhases) / static_cast<double>(steps);
        cycles.variance += squares;
    }
    cycles.freedom = (loops.size() - 1) * steps;
    cycles.variance = cycles.freedom > 0 ? cycles.variance / static_cast<double>(cycles.freedom) : 0.0;
    return cycles;
}

/// The first file with the amplitude of `file`, within 5 %.
const Cycles& first_of_same_amplitude(const std::vector<Cycles>& files, const Cycles& file) {
    for (const Cycles& other : files)
        if (std::abs(other.amplitude - file.amplitude) <= kLikeAmplitudes * other.amplitude) return other;
    return file;
}

/// Variance from one file to the next: of the loops (means over cycles) of files with the same amplitude (5 %) about their mean. A
/// dependence on speed is included if the files differ in frequency. NaN without two such files.
double setup_variance(const std::vector<Cycles>& files) {
    double squares = 0.0, freedom = 0.0;
    for (const Cycles& first : files) {
        std::vector<const Cycles*> equal;
        for (const Cycles& file : files)
            if (file.period > 0.0 && &first_of_same_amplitude(files, file) == &first) equal.push_back(&file);
        if (equal.size() < 2) continue;
        for (std::size_t p = 0; p < kPhases; ++p) {
            double mean = 0.0;
            for (const Cycles* file : equal) mean += file->mean[p] / static_cast<double>(equal.size());
            for (const Cycles* file : equal) squares += std::pow(file->mean[p] - mean, 2);
            freedom += static_cast<double>(equal.size()) - 1.0;
        }
    }
    return freedom > 0.0 ? squares / freedom : std::numeric_limits<double>::quiet_NaN();
}

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
