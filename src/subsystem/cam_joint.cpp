#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fusee/core/error.h"
#include "law.h"
#include "pull.h"

namespace fusee::subsystem {

namespace {

/// Places of the effects' parameters behind the zeros of the files (docs/subsystem-cases.md, eq. 8 to 11).
struct CamTerm {
    enum : std::size_t { kScale, kSeries, kPreload, kHysteresis, kHysteresisTravel, kCoulomb, kCoulombTravel, kArm, kArm2, kArm3, kTerms };
};

constexpr std::size_t kBends = 3;         // polynomials of the arm
constexpr double kLongestReversal = 0.1;  // of half the range of angles: a longer one is no reversal
constexpr double kAccuracy = 0.005;       // of the greatest torque: class of a torque sensor
constexpr double kShift = 0.4;            // of the law's range: beyond it, a preload has left the law
constexpr double kNarrow = 0.4;           // of the law's range: pulls over less of it are told
constexpr double kZero = 0.02;            // of the greatest torque: deviation of a sensor's zero
constexpr double kLeastFactor = 0.05;     // of the law's torque: a cam that turns its torque round is no cam of this law

constexpr const char* kOneWay =
    "no file turns back over the same angles; in one direction, friction looks like the sensor's zero, and hysteresis like another rate";

/// The driven angle of one file, thinned for a fit.
struct Pull {
    std::vector<double> q;
    LawCurve law;
    std::vector<std::size_t> zeros;  // the file's own; of a file that the case does not have: those of all its files
};

class CamJoint final : public Law {
public:
    CamJoint(const Case& subsystem_case, const Case* inputs);
    void predict(std::size_t record, const Values& values, std::vector<double>& predicted) const override;
    [[nodiscard]] std::vector<std::string> remarks() const override;
    [[nodiscard]] diagnosis::NextExperiment next() const override;
    [[nodiscard]] std::string split(const std::vector<std::size_t>& open) const override;

private:
    void set_range(const Case& subsystem_case);
    void set_means(const Case& subsystem_case);
    void set_pulls(const Case& subsystem_case, const Case& rows, std::size_t thin);
    void set_parameters(const Case& subsystem_case);
    void set_targets(const Case& subsystem_case, std::size_t thin);
    [[nodiscard]] double term(const Values& values, std::size_t t) const { return values[nominal + t]; }
    [[nodiscard]] std::array<double, kBends> bends(double q) const;
    [[nodiscard]] double factor(const Values& values, double q) const;
    [[nodiscard]] LawCurve measured_curve(const LawCurve& law, const Values& values) const;

    std::vector<Pull> pulls_;
    double sign_ = 1.0;                   // of torques in the files against those of the drive on the spring
    bool two_way_ = false;                // a file turns back
    core::Range law_range_;               // of the angles of all laws [rad]
    double middle_ = 0.0, half_ = 0.0;    // of the angles in all files of the case [rad]
    double torque_ = 0.0;                 // the greatest of the case's laws [Nm]
    double measured_ = 0.0;               // the greatest measured [Nm]
    double yield_ = 0.0;                  // of the dynamometer [rad/Nm]
    std::array<double, kBends> means_{};  // of the bends over the case's rows, weighted by the square of the law
};

/// Direction of motion, -1 while q falls to 1 while it rises, 0 before the first motion. It turns round over a travel, as friction that
/// first yields does.
std::vector<double> turn_of(const std::vector<double>& q, double travel) {
    std::vector<double> turn(q.size(), 0.0);
    for (std::size_t i = 1; i < q.size(); ++i) {
        const double step = q[i] - q[i - 1];
        const double goal = step > 0.0 ? 1.0 : step < 0.0 ? -1.0 : turn[i - 1];
        turn[i] = goal + (turn[i - 1] - goal) * std::exp(-std::abs(step) / travel);
    }
    return turn;
}

/// The same straight pieces with rows in between: the arm bends there too.
LawCurve dense(const LawCurve& law) {
    constexpr double kRows = 100.0;
    const double step = (law.q_rad.back() - law.q_rad.front()) / kRows;
    LawCurve out{law.file, {law.q_rad.front()}, {law.torque_Nm.front()}};
    for (std::size_t i = 1; i < law.q_rad.size(); ++i) {
        const double width = law.q_rad[i] - law.q_rad[i - 1], rise = law.torque_Nm[i] - law.torque_Nm[i - 1];
        const double pieces = std::max(1.0, std::round(width / step));
        for (double piece = 1.0; piece <= pieces; ++piece) {
            out.q_rad.push_back(piece == pieces ? law.q_rad[i] : law.q_rad[i - 1] + width * piece / pieces);
            out.torque_Nm.push_back(piece == pieces ? law.torque_Nm[i] : law.torque_Nm[i - 1] + rise * piece / pieces);
        }
    }
    return out;
}

CamJoint::CamJoint(const Case& subsystem_case, const Case* inputs) {
    measured_name = "torque_Nm";
    region_name = "q_rad";
    unit = "Nm";
    each_fold = over_region = weighs_equals = true;
    const Case& rows = inputs != nullptr ? *inputs : subsystem_case;
    const std::size_t thin = inputs != nullptr ? 1 : thinning(rows.records);
    set_range(subsystem_case);
    set_means(subsystem_case);
    set_pulls(subsystem_case, rows, thin);
    set_parameters(subsystem_case);
    if (inputs != nullptr) return;
    for (const Record& record : subsystem_case.records) require_same_units(record);
    set_targets(subsystem_case, thin);
    make_blocks(*this, subsystem_case, 2);
    std::vector<std::string> laws;
    for (const Record& record : subsystem_case.records) laws.push_back(record.law.file);
    add_scheme(*this, "law", laws);
}

void CamJoint::set_range(const Case& subsystem_case) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    law_range_ = {low, high};
    for (const Record& record : subsystem_case.records) {
        require_covered(record);
        law_range_ = {std::min(law_range_.low, record.law.q_rad.front()), std::max(law_range_.high, record.law.q_rad.back())};
        for (const double q : record.columns.at("q_rad")) low = std::min(low, q), high = std::max(high, q);
        for (const double torque : record.law.torque_Nm) torque_ = std::max(torque_, std::abs(torque));
        if (const auto column = record.columns.find("torque_Nm"); column != record.columns.end())
            for (const double torque : column->second) measured_ = std::max(measured_, std::abs(torque));
        two_way_ = two_way_ || turns_back(record.columns.at("q_rad"));
    }
    middle_ = 0.5 * (low + high);
    half_ = 0.5 * (high - low);
    if (!(half_ > 0.0)) throw core::InvalidInput("q_rad", "no motion in any file", "a joint that is turned back and forth");
    if (!(measured_ > 0.0)) measured_ = torque_;
    if (!(torque_ > 0.0)) throw core::InvalidInput("law", "no torque in any file", "the torque of a cam over its angle");
    sign_ = orientation_of(subsystem_case.records);
    if (const auto given = subsystem_case.parameters.find("dynamometer_Nm_per_rad"); given != subsystem_case.parameters.end())
        yield_ = 1.0 / given->second;
}

/// With these means the arm's curve holds nothing of law.scale: that is the same with and without law.arm.
void CamJoint::set_means(const Case& subsystem_case) {
    std::array<double, kBends> sums{};
    double weights = 0.0;
    for (const Record& record : subsystem_case.records)
        for (const double q : record.columns.at("q_rad")) {
            const double weight = std::pow(torque_at(record.law, q), 2);
            const auto at_q = bends(q);
            for (std::size_t k = 0; k < kBends; ++k) sums[k] += weight * at_q[k];
            weights += weight;
        }
    for (std::size_t k = 0; k < kBends && weights > 0.0; ++k) means_[k] = sums[k] / weights;
}

void CamJoint::set_pulls(const Case& subsystem_case, const Case& rows, std::size_t thin) {
    for (const Record& record : rows.records) {
        require_covered(record);
        const std::vector<double>& q = record.columns.at("q_rad");
        Pull pull{every(q, thin), dense(record.law), {}};
        for (double& torque : pull.law.torque_Nm) torque *= sign_;
        for (std::size_t f = 0; f < subsystem_case.records.size(); ++f)
            if (subsystem_case.records[f].file == record.file) pull.zeros = {f};
        if (pull.zeros.empty())
            for (std::size_t f = 0; f < subsystem_case.records.size(); ++f) pull.zeros.push_back(f);
        pulls_.push_back(std::move(pull));
    }
}

void CamJoint::set_parameters(const Case& subsystem_case) {
    nominal = subsystem_case.records.size();
    for (std::size_t f = 0; f < nominal; ++f) {
        parameters.push_back(
            {"sensor.torque_offset " + subsystem_case.records[f].file, "Nm", 0.0, -measured_, measured_, {}, kZero * measured_});
        own.push_back({f});
    }
    const double yielding = half_ / torque_;  // the joint's compliance as a whole, about
    const double least_travel = 1e-3 * half_;
    const double shift = kShift * (law_range_.high - law_range_.low);
    const Parameter terms[CamTerm::kTerms] = {{"scale", "", 0.0, -0.9, 4.0, {-0.1}},
                                              {"compliance", "rad/Nm", 0.0, 0.0, 2.0 * yielding, {0.02 * yielding, 0.2 * yielding}},
                                              {"preload", "rad", 0.0, -shift, shift, {-0.05 * half_, 0.05 * half_}},
                                              {"hysteresis", "", 0.0, 0.0, 0.9, {0.02}},
                                              {"reversal_rad", "rad", least_travel, least_travel, kLongestReversal * half_, {0.02 * half_}},
                                              {"coulomb", "Nm", 0.0, 0.0, 0.5 * torque_, {0.01 * torque_}},
                                              {"reversal_rad", "rad", least_travel, least_travel, kLongestReversal * half_, {0.02 * half_}},
                                              {"arm_1", "", 0.0, -0.9, 0.9, {0.02}},
                                              {"arm_2", "", 0.0, -0.9, 0.9, {0.02}},
                                              {"arm_3", "", 0.0, -0.9, 0.9, {0.02}}};
    parameters.insert(parameters.end(), std::begin(terms), std::end(terms));
    const std::size_t n = nominal;
    effects = {{{"law.scale"}, {n + CamTerm::kScale}, false, ""},
               {{"law.series"}, {n + CamTerm::kSeries}, false, ""},
               {{"law.preload"}, {n + CamTerm::kPreload}, false, ""},
               {{"law.hysteresis"}, {n + CamTerm::kHysteresis, n + CamTerm::kHysteresisTravel}, false, two_way_ ? "" : kOneWay},
               {{"law.coulomb"}, {n + CamTerm::kCoulomb, n + CamTerm::kCoulombTravel}, false, two_way_ ? "" : kOneWay},
               {{"law.arm"}, {n + CamTerm::kArm, n + CamTerm::kArm2, n + CamTerm::kArm3}, false, ""}};
}

void CamJoint::set_targets(const Case& subsystem_case, std::size_t thin) {
    double squares = 0.0;
    for (const Record& record : subsystem_case.records) squares += std::pow(scatter_of(record), 2);
    const double scatter = std::sqrt(squares / static_cast<double>(subsystem_case.records.size()));
    const auto given = subsystem_case.sensors.find("torque_noise_Nm");
    const double least = kAccuracy * measured_;
    unit_sigma = given != subsystem_case.sensors.end() ? given->second : std::max(scatter, least);
    if (given == subsystem_case.sensors.end())
        floor_remarks.push_back(fmt::format("sigma is {}, {:.3g} Nm: no sensors.torque_noise_Nm is given",
                                            scatter > least ? "the scatter from row to row" : "0.5 % of the greatest torque", unit_sigma));
    if (thin > 1) floor_remarks.push_back(fmt::format("the fits use every {}th row", thin));
    for (const Record& record : subsystem_case.records) {
        Target target;
        target.measured = every(record.columns.at("torque_Nm"), thin);
        target.sigma.assign(target.measured.size(), unit_sigma);
        target.region = every(record.columns.at("q_rad"), thin);
        target.group = "pull, " + record.file;
        targets.push_back(std::move(target));
    }
}

/// Legendre's polynomials 1 to 3 over the case's angles; beyond them as at the ends.
std::array<double, kBends> CamJoint::bends(double q) const {
    const double u = std::clamp((q - middle_) / half_, -1.0, 1.0);
    return {u, 0.5 * (3.0 * u * u - 1.0), 0.5 * u * (5.0 * u * u - 3.0)};
}

/// What the torque of the law is multiplied by at the joint's angle q.
double CamJoint::factor(const Values& values, double q) const {
    const auto at_q = bends(q);
    double arm = 1.0;
    for (std::size_t k = 0; k < kBends; ++k) arm += term(values, CamTerm::kArm + k) * (at_q[k] - means_[k]);
    return std::max(kLeastFactor, (1.0 + term(values, CamTerm::kScale)) * arm);
}

/// The torque over the angle as the dynamometer reads it, without friction: what yields in series turns by c T on top of the cam's angle.
/// Where the law falls so steeply that the angle would turn back, the joint snaps over the rows that it would meet twice.
LawCurve CamJoint::measured_curve(const LawCurve& law, const Values& values) const {
    const double yields = yield_ + term(values, CamTerm::kSeries), preload = term(values, CamTerm::kPreload);
    LawCurve all, curve;
    for (std::size_t i = 0; i < law.q_rad.size(); ++i) {
        all.torque_Nm.push_back(factor(values, law.q_rad[i] - preload) * law.torque_Nm[i]);
        all.q_rad.push_back(law.q_rad[i] - preload + yields * all.torque_Nm.back());
    }
    std::vector<double> least(all.q_rad);  // of a row and all behind it
    for (std::size_t i = least.size() - 1; i-- > 0;) least[i] = std::min(least[i], least[i + 1]);
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < all.q_rad.size(); ++i) {
        const bool once = all.q_rad[i] > most && (i + 1 == least.size() || all.q_rad[i] < least[i + 1]);
        most = std::max(most, all.q_rad[i]);
        if (!once) continue;
        curve.q_rad.push_back(all.q_rad[i]);
        curve.torque_Nm.push_back(all.torque_Nm[i]);
    }
    if (curve.q_rad.size() < 2) return {law.file, {law.q_rad.front(), law.q_rad.back()}, {0.0, 0.0}};  // it snaps over all of them
    return curve;
}

void CamJoint::predict(std::size_t record, const Values& values, std::vector<double>& predicted) const {
    const Pull& pull = pulls_[record];
    const LawCurve curve = measured_curve(pull.law, values);
    double zero = 0.0;
    for (const std::size_t f : pull.zeros) zero += values[f] / static_cast<double>(pull.zeros.size());
    predicted.resize(pull.q.size());
    for (std::size_t i = 0; i < predicted.size(); ++i) predicted[i] = torque_at(curve, pull.q[i]);
    const double a = term(values, CamTerm::kHysteresis), c = term(values, CamTerm::kCoulomb);
    if (a != 0.0) {
        const std::vector<double> turn = turn_of(pull.q, term(values, CamTerm::kHysteresisTravel));
        for (std::size_t i = 0; i < predicted.size(); ++i) predicted[i] += a * std::abs(predicted[i]) * turn[i];
    }
    if (c != 0.0) {
        const std::vector<double> turn = turn_of(pull.q, term(values, CamTerm::kCoulombTravel));
        for (std::size_t i = 0; i < predicted.size(); ++i) predicted[i] += c * turn[i];
    }
    for (double& torque : predicted) torque = zero + sign_ * torque;
}

std::vector<std::string> CamJoint::remarks() const {
    std::vector<std::string> all{
        "law.scale: another rate of the spring, another seat of a slider and another gain of the torque sensor scale the law alike; pulls "
        "at "
        "two seats, and weights on the sensor, distinguish them"};
    if (const double share = 2.0 * half_ / (law_range_.high - law_range_.low); share < kNarrow)
        all.push_back(
            fmt::format("the pulls go over {:.0f} % of the law's angles: what is another rate there may be the arm's error at these "
                        "angles, and says nothing of the others",
                        100.0 * share));
    if (yield_ == 0.0)
        all.emplace_back("no bench.dynamometer_Nm_per_rad: what the dynamometer yields is in the angle, and a law.series would hold it");
    if (pulls_.size() < 2) all.emplace_back("one file: no other cam is held out, so that a false cause can pass");
    return all;
}

diagnosis::NextExperiment CamJoint::next() const {
    diagnosis::NextExperiment next;
    next.experiment = "pull";
    next.variable = "q_rad";
    next.set_points = {middle_ - half_, middle_, middle_ + half_};
    next.cost = 20.0;
    next.text = fmt::format(
        "the spring alone on the bench, without a cam: its rate tells law.scale from the cam's arm; then each cam again from {:.3g} to "
        "{:.3g} "
        "rad, taken off and mounted again in between, and the dynamometer against a rigid bar: the floor from set-up to set-up, and its "
        "own "
        "compliance",
        next.set_points.front(), next.set_points.back());
    return next;
}

/// What each open effect needs, in the order of the effects; where only one of two is open, the other answers too.
std::string CamJoint::split(const std::vector<std::size_t>& open) const {
    const std::string needs[] = {
        fmt::format(
            "a pull over more of the law, {:.3g} to {:.3g} rad and to both sides of its least torque: a rate scales the torque there, a "
            "preload shifts the angle",
            law_range_.low, law_range_.high),
        "the cam's own angle under torque, or the dynamometer against a rigid bar: what yields in series shows there, another rate does "
        "not",
        "the torque with the drive uncoupled: it is the sensor's zero; what is left of the offset is a preload, or an angle's offset",
        "loops to a small and to a great torque: hysteresis grows with the torque, Coulomb friction does not",
        "",   // that of law.hysteresis
        ""};  // next() says it
    std::string text;
    for (std::size_t e = 0; e < effects.size(); ++e) {
        const bool asked = std::find(open.begin(), open.end(), e) != open.end();
        if (asked && !needs[e].empty()) text += (text.empty() ? "" : "; ") + needs[e];
    }
    if (!two_way_)
        text += std::string(text.empty() ? "" : "; ") + "a pull that turns back over the same angles, for hysteresis and friction";
    return text;
}

}  // namespace

std::unique_ptr<Law> cam_joint(const Case& subsystem_case, const Case* inputs) {
    return std::make_unique<CamJoint>(subsystem_case, inputs);
}

}  // namespace fusee::subsystem
