#include "pull.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "fusee/core/error.h"
#include "fusee/core/units.h"
#include "law.h"

namespace fusee::subsystem {

namespace {

constexpr double kBeyond = 0.1;                    // of the law's range: how far beyond its ends a pull may go
constexpr double kLeastReturn = 0.1;               // of a file's range of angles: a shorter way back is none
constexpr std::size_t kLeastReturnRows = 4;        // in each direction
constexpr double kLowGain = 0.1, kHighGain = 5.0;  // measured torque over that of the law: beyond them, one of the two has another unit
constexpr double kFollows = 0.8;                   // explained share of a torque that follows a law
constexpr double kRounding = 1e-9;                 // unexplained share of a torque that is the law's
constexpr double kFarBetter = 0.05;                // of the squares that the law leaves as it is read
constexpr double kDegree = core::kPi / 180.0;

/// Another unit or sign in which a pull or its law may be.
struct Reading {
    double angle;          ///< the law's angle over the pull's number
    const char* question;  ///< "": none
};
constexpr Reading kAngles[] = {
    {1.0, ""}, {kDegree, "are these degrees?"}, {1.0 / kDegree, "is q_rad of the law in degrees?"}, {1e-3, "are these mrad?"}};
constexpr Reading kTorques[] = {{1.0, ""},
                                {1000.0, "are these mNm or Nmm?"},
                                {1e-3, "is torque_Nm of the law in mNm or Nmm?"},
                                {100.0, "are these Ncm?"},
                                {0.01, "is torque_Nm of the law in Ncm?"},
                                {1.0 / 0.0980665, "are these kgf cm?"},
                                {0.0980665, "is torque_Nm of the law in kgf cm?"}};

bool covers(const LawCurve& law, const std::vector<double>& q, double factor) {
    const double slack = kBeyond * (law.q_rad.back() - law.q_rad.front());
    return std::all_of(q.begin(), q.end(),
                       [&](double at) { return factor * at >= law.q_rad.front() - slack && factor * at <= law.q_rad.back() + slack; });
}

Line line_of(const Record& record, double factor) {
    std::vector<double> torque;
    for (const double q : record.columns.at("q_rad")) torque.push_back(torque_at(record.law, factor * q));
    return line_through(torque, record.columns.at("torque_Nm"));
}

/// The unit that brings a gain nearest to 1, if that is a spring's error and no other unit's.
const Reading* unit_of(double gain) {
    const Reading* nearest = kTorques;
    for (const Reading& unit : kTorques)
        if (std::abs(std::log(gain / unit.angle)) < std::abs(std::log(gain / nearest->angle))) nearest = &unit;
    return std::abs(std::log(gain / nearest->angle)) < std::log(2.5) ? nearest : nullptr;
}

struct Question {
    int changes = 0;  ///< the fewer, the likelier
    double left = 1.0;
    std::string column, text;
};

/// What must be asked if the pull follows its law with this factor of the angle only.
std::optional<Question> question_of(const Record& record, const Reading& angle, double sign) {
    const auto& q = record.columns.at("q_rad");
    if (!covers(record.law, q, sign * angle.angle)) return {};
    const Line line = line_of(record, sign * angle.angle);
    const Reading* const unit = line.explained < kFollows ? nullptr : unit_of(std::abs(line.gain));
    if (unit == nullptr) return {};
    Question out{0, 1.0 - line.explained, "torque_Nm", ""};
    if (*angle.question != '\0') ++out.changes, out.column = "q_rad", out.text = angle.question;
    if (*unit->question != '\0') ++out.changes, out.text += std::string(out.text.empty() ? "" : " ") + unit->question;
    if (sign < 0.0) ++out.changes, out.column = "q_rad";
    if (line.gain < 0.0) ++out.changes;
    if (sign < 0.0 || line.gain < 0.0)
        out.text +=
            std::string(out.text.empty() ? "" : " ") + (sign > 0.0        ? "is the sign of torque_Nm, or of q_rad, that of the law?"
                                                        : line.gain > 0.0 ? "is the sign of q_rad that of the law?"
                                                                          : "are the signs of q_rad and torque_Nm those of the law?");
    return out;
}

/// Turning points of the angle: rows where it goes back by more than `least` after them.
std::vector<std::size_t> turns_of(const std::vector<double>& q, double least) {
    std::vector<std::size_t> turns{0};
    std::size_t low = 0, high = 0;
    int leg = 0;  // direction; 0: not known yet
    for (std::size_t i = 1; i < q.size(); ++i) {
        if (q[i] < q[low]) low = i;
        if (q[i] > q[high]) high = i;
        if (leg >= 0 && q[high] - q[i] > least) {
            if (leg > 0) turns.push_back(high);
            leg = -1, low = i;
        } else if (leg <= 0 && q[i] - q[low] > least) {
            if (leg < 0) turns.push_back(low);
            leg = 1, high = i;
        }
    }
    turns.push_back(leg > 0 ? high : low);
    return turns;
}

}  // namespace

double torque_at(const LawCurve& curve, double q) {
    const auto inside = std::upper_bound(curve.q_rad.begin() + 1, curve.q_rad.end() - 1, q);
    const auto i = static_cast<std::size_t>(inside - curve.q_rad.begin());
    const double share = (q - curve.q_rad[i - 1]) / (curve.q_rad[i] - curve.q_rad[i - 1]);
    return curve.torque_Nm[i - 1] + share * (curve.torque_Nm[i] - curve.torque_Nm[i - 1]);
}

Line line_through(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) mean_x += x[i] / n, mean_y += y[i] / n;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
        yy += (y[i] - mean_y) * (y[i] - mean_y);
    }
    if (!(xx > 0.0 && yy > 0.0)) return {mean_y, 0.0, 0.0};
    return {mean_y - xy / xx * mean_x, xy / xx, xy * xy / (xx * yy)};
}

double orientation_of(const std::vector<Record>& records) {
    double slope = 0.0, mean = 0.0, size = 0.0;
    for (const Record& record : records) {
        const auto& q = record.columns.at("q_rad");
        std::vector<double> torque;
        for (const double at : q) torque.push_back(torque_at(record.law, at));
        const Line line = line_through(q, torque);
        slope += (line.gain > 0.0 ? 1.0 : -1.0) * line.explained;
        for (const double t : torque) mean += t, size += std::abs(t);
    }
    constexpr double kFlat = 1e-6;
    if (std::abs(slope) > kFlat) return slope > 0.0 ? 1.0 : -1.0;
    return mean < -kFlat * size ? -1.0 : 1.0;
}

bool turns_back(const std::vector<double>& q) {
    const auto [least, most] = std::minmax_element(q.begin(), q.end());
    const std::vector<std::size_t> turns = turns_of(q, kLeastReturn * (*most - *least));
    for (std::size_t t = 1; t + 1 < turns.size(); ++t) {
        const double low = std::max(std::min(q[turns[t - 1]], q[turns[t]]), std::min(q[turns[t]], q[turns[t + 1]]));
        const double high = std::min(std::max(q[turns[t - 1]], q[turns[t]]), std::max(q[turns[t]], q[turns[t + 1]]));
        const auto rows = [&](std::size_t leg) {
            return std::count_if(q.begin() + static_cast<std::ptrdiff_t>(turns[leg]) + 1,
                                 q.begin() + static_cast<std::ptrdiff_t>(turns[leg + 1]) + 1,
                                 [&](double at) { return at >= low && at <= high; });
        };
        if (static_cast<std::size_t>(std::min(rows(t - 1), rows(t))) >= kLeastReturnRows) return true;
    }
    return false;
}

double scatter_of(const Record& record) {
    const Line line = line_of(record, 1.0);
    std::vector<double> left;
    const auto& q = record.columns.at("q_rad");
    for (std::size_t i = 0; i < q.size(); ++i) left.push_back(record.columns.at("torque_Nm")[i] - line.gain * torque_at(record.law, q[i]));
    return scatter_of(left);
}

void require_covered(const Record& record) {
    const LawCurve& law = record.law;
    if (law.q_rad.size() < 2) throw core::InvalidInput(record.file + ": law", "missing", "a law of two rows or more");
    const auto& q = record.columns.at("q_rad");
    if (covers(law, q, 1.0)) return;
    std::string allowed = fmt::format("angles of {}: {:g} to {:g} rad", law.file, law.q_rad.front(), law.q_rad.back());
    for (const Reading& angle : kAngles)
        if (*angle.question != '\0' && covers(law, q, angle.angle)) {
            allowed += std::string("; ") + angle.question;
            break;
        }
    if (covers(law, q, -1.0)) allowed += "; is the sign of q_rad that of the law?";
    const auto beyond = std::find_if(q.begin(), q.end(), [&](double at) { return !covers(law, {at}, 1.0); });
    throw core::InvalidInput(record.file + ": q_rad", fmt::format("{:g}", *beyond), allowed);
}

void require_same_units(const Record& record) {
    const Line read = line_of(record, 1.0);
    const bool fits = read.gain >= kLowGain && read.gain <= kHighGain;
    if (fits && 1.0 - read.explained < kRounding) return;
    std::optional<Question> best;
    for (const Reading& angle : kAngles)
        for (const double sign : {1.0, -1.0}) {
            std::optional<Question> other = question_of(record, angle, sign);
            if (!other || other->changes == 0 || (fits && other->left > kFarBetter * (1.0 - read.explained))) continue;
            const auto rank = [](const Question& q) { return std::make_pair(q.changes, q.left); };
            if (!best || rank(*other) < rank(*best)) best = std::move(other);
        }
    if (!best && (fits || read.explained < kFollows)) return;
    throw core::InvalidInput(record.file + ": " + (best ? best->column : "torque_Nm"),
                             fmt::format("follows {} times {:.3g}", record.law.file, read.gain),
                             fmt::format("torque and angle in the units and with the signs of the law{}",
                                         best ? "; " + best->text : fmt::format(", {:g} to {:g} times", kLowGain, kHighGain)));
}

}  // namespace fusee::subsystem
