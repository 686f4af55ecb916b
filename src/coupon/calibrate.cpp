#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "figures.h"
#include "fusee/core/error.h"
#include "fusee/core/lists.h"
#include "fusee/coupon/calibration.h"

namespace fusee::coupon {

namespace {

using core::m_from_mm;

constexpr double kGauge_mm = 0.01, kTape_mm = 0.1, kScale = 0.0;  // resolution of a caliper, a ruler and an unknown instrument
constexpr double kMostShrinkage = 0.1;                            // a larger shrinkage means another unit
constexpr std::size_t kLeastOfLine = 3, kLeastOfMean = 2;
constexpr std::array kLengths{Item::kLengthX, Item::kLengthY, Item::kLengthZ};

std::size_t different(const std::vector<Row>& rows) { return core::sorted_unique(core::each<double>(rows, &Row::given)).size(); }

bool makes_line(const std::vector<Row>& rows) { return rows.size() >= kLeastOfLine && different(rows) >= 2; }

Estimate mean_of(const std::vector<double>& values, double resolution) {
    const auto count = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    double squares = 0.0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    const double scatter = std::max(std::sqrt(squares / (count - 1.0)), resolution / std::sqrt(12.0));
    return {mean, scatter / std::sqrt(count), count - 1.0};
}

/// Result of a yes-or-no ladder: the least yes and the greatest no.
struct Ladder {
    double greatest_no = -std::numeric_limits<double>::infinity();
    double least_yes = std::numeric_limits<double>::infinity();
    double greatest_yes = -std::numeric_limits<double>::infinity();
    [[nodiscard]] bool fits() const { return std::isfinite(least_yes); }
    [[nodiscard]] bool between() const { return fits() && std::isfinite(greatest_no); }
};

Ladder ladder_of(const std::vector<Row>& rows, const std::string& field) {
    Ladder ladder;
    for (const Row& row : rows) {
        if (row.measured == 0.0) ladder.greatest_no = std::max(ladder.greatest_no, row.given);
        if (row.measured == 0.0) continue;
        ladder.least_yes = std::min(ladder.least_yes, row.given);
        ladder.greatest_yes = std::max(ladder.greatest_yes, row.given);
    }
    if (ladder.greatest_no >= ladder.least_yes)
        throw core::InvalidInput(field, fmt::format("yes at {:g}, no at {:g}", ladder.least_yes, ladder.greatest_no),
                                 "yes from one row of the ladder on: a shaft or cable that fits an opening fits every larger one");
    return ladder;
}

class Calibrator {
public:
    Calibrator(const Sheet& sheet, const Present& present, const std::string& file) : sheet_(sheet), present_(present), file_(file) {}

    Calibration run() {
        for (const int axis : {0, 1, 2}) shrinkage(axis);
        bore();
        groove();
        disc();
        series_spring();
        parallel_spring();
        return std::move(result_);
    }

private:
    const Figure& add(Figure f, const Estimate& estimate) {
        set_estimate(f, estimate);
        return add(std::move(f));
    }
    const Figure& add(Figure f) {
        set_present(f, present_);
        return result_.figures.emplace_back(std::move(f));
    }
    void unknown(std::string id, std::string why) { result_.unknown.push_back({std::move(id), std::move(why)}); }
    [[nodiscard]] std::string field(const char* item) const { return file_ + ": " + item; }

    /// eq. 1: measured = (1 - s) L + e.
    void shrinkage(int axis) {
        const std::string name(1, "xyz"[axis]), item = "length_" + name;
        const std::vector<Row> rows = sheet_.of(kLengths[axis]);
        if (!makes_line(rows)) return unknown("shrink_" + name, fmt::format("needs 3 rows {} of 2 lengths that differ", item));
        const Line line = fit_line(rows, kGauge_mm);
        Estimate s = line.slope;
        s.value = 1.0 - s.value;
        if (std::abs(s.value) > kMostShrinkage)
            throw core::InvalidInput(field(item.c_str()), fmt::format("a shrinkage of {:.3g} %", 100.0 * s.value),
                                     fmt::format("at most {:g} % either way: lengths in mm, as drawn", 100.0 * kMostShrinkage));
        s.value = add(make_figure("shrink_" + name, "shrinkage along " + name, kShrinkKeys[axis], "%", 100.0, rows.size()), s).used();
        shrink_[axis] = s;
        const Estimate contour = sum({{1e-3, line.at_0}});
        add(make_figure("contour_" + name, "outer lengths along " + name + " come out longer by", "", "mm", 1e3, rows.size()), contour);
    }

    /// Shrinkage of one axis, or the mean of those in the plane: the scale of a compensated file.
    [[nodiscard]] Estimate settled(int axis) const {
        const auto known = present_.find(kShrinkKeys[axis]);
        const Estimate as_is{known == present_.end() ? 0.0 : known->second, 0.0, std::numeric_limits<double>::infinity()};
        return shrink_[axis].value_or(as_is);
    }
    [[nodiscard]] Estimate in_plane() const { return sum({{0.5, settled(0)}, {0.5, settled(1)}}); }
    [[nodiscard]] bool plane_known() const { return shrink_[0] && shrink_[1]; }

    /// eq. 2: b = (1 - s) D - measured.
    void bore() {
        const std::vector<Row> rows = sheet_.of(Item::kBore);
        const std::optional<Figure> by_shaft = bore_by_shaft();
        if (rows.size() < kLeastOfMean) {
            if (by_shaft) add(*by_shaft);
            return by_shaft ? shrinkage_inside("bore_offset") : unknown("bore_offset", "needs 2 rows bore, or shaft and shaft_enters");
        }
        const Estimate s = in_plane();
        std::vector<double> offsets;
        double diameter = 0.0;
        for (const Row& row : rows) {
            offsets.push_back(m_from_mm((1.0 - s.value) * row.given - row.measured));
            diameter += m_from_mm(row.given) / static_cast<double>(rows.size());
        }
        Estimate offset = sum({{1.0, mean_of(offsets, m_from_mm(kGauge_mm))}, {-diameter, {0.0, s.deviation, s.freedom}}});
        const Figure& found = add(make_figure("bore_offset", "bores come out smaller by", kBoreOffsetKey, "mm", 1e3, rows.size()), offset);
        if (by_shaft && (found.range.high < by_shaft->range.low || found.range.low > by_shaft->range.high))
            result_.remarks.push_back(fmt::format(
                "bore_offset: {:.3f} mm by the gauge, {:.3f} to {:.3f} mm by the shaft: a rough or oval hole; the gauge's value is used",
                1e3 * found.value, 1e3 * by_shaft->range.low, 1e3 * by_shaft->range.high));
        shrinkage_inside("bore_offset");
    }
    void shrinkage_inside(const std::string& id) {
        if (!plane_known()) result_.remarks.push_back(id + " includes the holes' shrinkage along x and y where it is unknown");
    }
    /// The same from the holes that the shaft enters: between the last that it does not enter and the first that it enters.
    std::optional<Figure> bore_by_shaft() {
        const std::vector<Row> tries = sheet_.of(Item::kShaftEnters), shafts = sheet_.of(Item::kShaft);
        const Ladder ladder = ladder_of(tries, field("shaft_enters"));
        if (!tries.empty() && !ladder.between())
            result_.remarks.push_back(std::string("shaft_enters: the shaft enters ") + (ladder.fits() ? "every" : "no") +
                                      " hole, so the ladder gives no value");
        if (shafts.empty() || !ladder.between()) return std::nullopt;
        double shaft = 0.0;
        for (const Row& row : shafts) shaft += row.measured / static_cast<double>(shafts.size());
        const auto offset = [&](double drawn) { return m_from_mm((1.0 - in_plane().value) * drawn - shaft); };
        Figure f = make_figure("bore_offset", "bores come out smaller by (by the shaft)", kBoreOffsetKey, "mm", 1e3, tries.size());
        f.range = {offset(ladder.greatest_no), offset(ladder.least_yes)};
        f.value = 0.5 * (f.range.low + f.range.high);
        f.ladder = true;
        return f;
    }

    void groove() {
        const std::vector<Row> tries = sheet_.of(Item::kCableSeats);
        const Ladder ladder = ladder_of(tries, field("cable_seats"));
        if (!ladder.fits())
            return unknown("groove_ratio",
                           tries.empty() ? "needs rows cable_seats" : "the cable seats in no groove: it is thicker than nominal");
        Figure f = make_figure("groove_ratio", "tightest groove in which the cable seats", kGrooveRatioKey, "", 1.0, tries.size());
        f.value = ladder.least_yes;
        f.range = {ladder.least_yes, ladder.greatest_yes};
        f.ladder = true;
        add(f);
    }

    /// eq. 3 and 4: R from cable drawn off over turns, or from torque over tension; the axis lies R - (1 - s) R_floor - d/2 farther out.
    void disc() {
        const std::vector<Row> pulls = sheet_.of(Item::kDiscPull), torques = sheet_.of(Item::kDiscTorque);
        const bool by_pull = makes_line(pulls), by_torque = makes_line(torques);
        if (!by_pull && !by_torque) {
            unknown("disc_radius", "needs 3 rows disc_pull or disc_torque that differ");
            return unknown("cable_axis", "needs the disc's effective radius");
        }
        const Estimate pulled = by_pull ? sum({{1e-3 / (2.0 * core::kPi), fit_line(pulls, kTape_mm).slope}}) : Estimate{};
        const Estimate turned = by_torque ? fit_line(torques, kScale).slope : Estimate{};
        if (by_pull && by_torque && std::abs(pulled.value - turned.value) > sum({{1.0, pulled}, {-1.0, turned}}).interval().width() / 2.0)
            result_.remarks.push_back(
                fmt::format("disc_radius: {:.3f} mm by the cable drawn off, {:.3f} mm by torques: friction of the "
                            "shaft, or cable elongation; the more exact value is used",
                            1e3 * pulled.value, 1e3 * turned.value));
        radius_ = by_pull && (!by_torque || pulled.deviation <= turned.deviation) ? pulled : turned;
        add(make_figure("disc_radius", "effective radius of the disc", "", "mm", 1e3,
                        radius_->value == pulled.value ? pulls.size() : torques.size()),
            *radius_);
        cable_axis();
    }
    void cable_axis() {
        if (!(sheet_.disc_floor_mm > 0.0) || !(sheet_.cable_diameter_mm > 0.0))
            return unknown("cable_axis", "needs the rows disc_floor and cable_diameter with their nominal values");
        if (!plane_known()) return unknown("cable_axis", "needs the shrinkage along x and y: without it the disc's radius is unknown");
        const double floor = m_from_mm(sheet_.disc_floor_mm);
        Estimate axis = sum({{1.0, *radius_}, {floor, in_plane()}});
        axis.value -= floor + 0.5 * m_from_mm(sheet_.cable_diameter_mm);
        add(make_figure("cable_axis", "distance of the cable's neutral axis beyond d/2", kCableAxisKey, "mm", 1e3, 0), axis);
        result_.figures.back().rows = result_.find("disc_radius")->rows;
    }

    /// eq. 5: on the disc, force over pull is k_t/R^2.
    void series_spring() {
        const std::vector<Row> rows = sheet_.of(Item::kSeriesSpring);
        if (!makes_line(rows) || !radius_)
            return unknown("series_rate",
                           radius_ ? "needs 3 rows series_spring" : "needs 3 rows series_spring and the disc's effective radius");
        const Estimate c = rising(sum({{1e3, fit_line(rows, kScale).slope}}), "series_spring");
        const double r = radius_->value;
        Estimate rate = sum({{r * r, c}, {2.0 * c.value * r, {0.0, radius_->deviation, radius_->freedom}}});
        add(make_figure("series_rate", "rate of the torsion spring", kSeriesRateKey, "Nm/rad", 1.0, rows.size()), rate);
    }
    /// eq. 6.
    void parallel_spring() {
        const std::vector<Row> rows = sheet_.of(Item::kParallelSpring);
        if (!makes_line(rows)) return unknown("parallel_rate", "needs 3 rows parallel_spring");
        const Estimate k = rising(sum({{1e3, fit_line(rows, kScale).slope}}), "parallel_spring");
        add(make_figure("parallel_rate", "rate of the compression spring", kParallelRateKey, "N/m", 1.0, rows.size()), k);
    }
    [[nodiscard]] Estimate rising(const Estimate& slope, const char* item) const {
        if (slope.value > 0.0) return slope;
        throw core::InvalidInput(field(item), fmt::format("a slope of {:.3g} N/m", slope.value), "forces that rise with the travel");
    }

    const Sheet& sheet_;
    const Present& present_;
    const std::string& file_;
    Calibration result_;
    std::array<std::optional<Estimate>, 3> shrink_;  // the used values
    std::optional<Estimate> radius_;                 // of the disc [m]
};

}  // namespace

const Figure* Calibration::find(const std::string& id) const { return core::find_by(figures, &Figure::id, id); }

Calibration calibrate(const Sheet& sheet, const Present& present, const std::string& file) {
    return Calibrator(sheet, present, file).run();
}

}  // namespace fusee::coupon
