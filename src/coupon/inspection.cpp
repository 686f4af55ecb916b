#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "figures.h"
#include "fusee/core/error.h"
#include "fusee/coupon/calibration.h"
#include "fusee/math/statistics.h"

namespace fusee::coupon {

namespace {

using core::mm_from_m;

constexpr double kGauge = 0.01e-3;          // last digit of a dial gauge [m]
constexpr double kLeastIndependent = 0.03;  // share of a column that the others do not explain
constexpr double kRound = 1e-6;             // lever of a turn over the radius that is only rounding
constexpr std::size_t kSpareRows = 2;       // more rows than unknowns

bool on_contour(const InspectionRow& row) { return row.item == Inspected::kContour || row.item == Inspected::kRim; }

/// Factors of offset, x, y and rotation in a row's deviation.
std::array<double, 4> factors(const InspectionRow& row) {
    const double nx = std::cos(row.normal), ny = std::sin(row.normal);
    return {1.0, nx, ny, row.x * ny - row.y * nx};
}

struct Solved {
    math::LinearFit fit;
    bool independent = false;  ///< every column has a share that the others do not explain
};

/// The first `terms` of offset, x, y and rotation. Nothing: too few rows, or columns that depend on each other exactly.
std::optional<Solved> solved(const std::vector<InspectionRow>& rows, std::size_t terms) {
    if (rows.size() < terms + (terms > 1 ? kSpareRows : 1)) return std::nullopt;
    math::LinearModel model;
    model.x.assign(terms, {});
    std::vector<double> squares(terms, 0.0);
    double radii = 0.0;
    for (const InspectionRow& row : rows) {
        model.y.push_back(row.deviation);
        const auto f = factors(row);
        radii += row.x * row.x + row.y * row.y;
        for (std::size_t j = 0; j < terms; ++j) {
            model.x[j].push_back(f[j]);
            squares[j] += f[j] * f[j];
        }
    }
    if (terms > 3 && squares[3] <= kRound * kRound * radii) return std::nullopt;  // a circle about the bore
    try {
        Solved result{math::fit_linear(model), true};
        for (std::size_t j = 0; j < terms; ++j)
            result.independent &= std::sqrt(result.fit.cofactors[j][j] * squares[j]) <= 1.0 / kLeastIndependent;
        return result;
    } catch (const core::InvalidInput&) {  // dependent columns
        return std::nullopt;
    }
}

/// The largest set of terms that the rows determine; a single row is its own offset.
ContourFit fitted(std::vector<InspectionRow> rows) {
    ContourFit fit;
    for (const std::size_t terms : {4U, 3U, 1U}) {
        const auto found = solved(rows, terms);
        if (!found || (terms > 1 && !found->independent)) continue;
        const double scatter = std::max(found->fit.deviation, kGauge / std::sqrt(12.0));
        const auto estimate = [&](std::size_t j) {
            return Estimate{found->fit.coefficients[j], scatter * std::sqrt(found->fit.cofactors[j][j]),
                            static_cast<double>(found->fit.freedom)};
        };
        fit.offset = estimate(0);
        fit.shifts = terms >= 3;
        fit.turns = terms >= 4;
        if (fit.shifts) fit.x = estimate(1), fit.y = estimate(2);
        if (fit.turns) fit.rotation = estimate(3);
        fit.form = found->fit.residuals;
        break;
    }
    if (fit.form.empty()) {
        fit.offset = {rows.front().deviation, kGauge / std::sqrt(12.0), std::numeric_limits<double>::infinity()};
        fit.form.assign(rows.size(), 0.0);
    }
    fit.rows = std::move(rows);
    return fit;
}

/// Largest |share| of the rows' arms, with its sign [1]. The arms of the law are those of the sheet plus what is `compensated` [m].
template <class Share>
double worst_of_arm(const ContourFit& fit, double compensated, const Share& share) {
    double worst = 0.0;
    for (std::size_t i = 0; i < fit.rows.size(); ++i) {
        const double relative = share(i) / (fit.rows[i].nominal + compensated);
        if (std::abs(relative) > std::abs(worst)) worst = relative;
    }
    return worst;
}

template <class Share>
double largest(const ContourFit& fit, const Share& share) {
    double most = 0.0;
    for (std::size_t i = 0; i < fit.rows.size(); ++i) most = std::max(most, std::abs(share(i)));
    return most;
}

class Inspector {
public:
    Inspector(const InspectionSheet& sheet, const Present& present) : sheet_(sheet), present_(present), fit_(fit_contour(sheet)) {}

    Calibration run() {
        figures();
        arm();
        contour();
        if (fit_.shifts) eccentricity();
        if (fit_.turns) rotation();
        form();
        others();
        return std::move(result_);
    }

private:
    [[nodiscard]] bool is_rim() const { return fit_.rows.front().item == Inspected::kRim; }
    [[nodiscard]] double allowed() const { return fit_.rows.front().high; }

    void add(Figure f, const Estimate& estimate) {
        set_estimate(f, estimate);
        set_present(f, present_);
        result_.figures.push_back(std::move(f));
    }
    void figures() {
        const std::size_t n = fit_.rows.size();
        add(make_figure("contour_offset", "contour beyond the nominal along its normal", is_rim() ? "" : contour_key(sheet_.part), "mm",
                        1e3, n),
            fit_.offset);
        const char* few = "the rows' normals do not tell it from the offset: measure more rows, over more of the arc";
        if (!fit_.shifts) result_.unknown.push_back({"eccentricity", few});
        if (fit_.shifts) {
            add(make_figure("eccentricity_x", "contour displaced along x from the bore", "", "mm", 1e3, n), fit_.x);
            add(make_figure("eccentricity_y", "contour displaced along y from the bore", "", "mm", 1e3, n), fit_.y);
        }
        if (fit_.turns)
            add(make_figure("rotation", "contour turned counter-clockwise against the key", "", "deg", core::deg_from_rad(1.0), n),
                fit_.rotation);
        else
            result_.unknown.push_back({"rotation", fit_.shifts ? "on this contour it looks like an eccentricity: use the key's row" : few});
    }
    /// A deviation along the normal is an error of the arm of the same size (docs/theory/calibration.md, eq. 10); a rim's arm follows its
    /// slope.
    void arm() {
        if (is_rim()) {
            result_.remarks.emplace_back("the arm of a roller cam follows the slope of the rim: no percent is stated for deviations");
            return;
        }
        const double compensated = result_.find("contour_offset")->present;  // the arms of the file are smaller by it
        const double as_made = worst_of_arm(fit_, compensated, [&](std::size_t i) { return fit_.rows[i].deviation - compensated; }),
                     centred = worst_of_arm(fit_, compensated, [&](std::size_t i) { return fit_.rows[i].deviation - fit_.offset.value; }),
                     formed = worst_of_arm(fit_, compensated, [&](std::size_t i) { return fit_.form[i]; });
        result_.remarks.push_back(fmt::format(
            "arm of {}, at its worst row: {:+.2f} % as made, {:+.2f} % without the offset, {:+.2f} % without offset, eccentricity and "
            "rotation (form error)",
            sheet_.part, 100.0 * as_made, 100.0 * centred, 100.0 * formed));
    }

    void judge(const char* id, std::string what, double measured_mm, double allowed_mm, core::Suggestion suggestion) {
        core::Finding f;
        f.rule = std::string("inspection.") + id;
        f.what = std::move(what);
        f.measured = measured_mm;
        f.bound = core::Bound::kAtMost;
        f.allowed = allowed_mm;
        f.unit = "mm";
        f.where = sheet_.part;
        f.suggestion = std::move(suggestion);
        f.source = "the inspection sheet's allowed deviation";
        result_.findings.push_back(core::judged(std::move(f), core::Severity::kWarning));
    }
    void contour() {
        const double most = largest(fit_, [&](std::size_t i) { return fit_.rows[i].deviation; });
        judge("contour", fmt::format("largest deviation of {} rows of the contour", fit_.rows.size()), mm_from_m(most),
              mm_from_m(allowed()),
              is_rim() ? core::Suggestion() : core::change(contour_key(sheet_.part), fmt::format("{:.3f}", mm_from_m(fit_.offset.value))));
    }
    void eccentricity() {
        const double x = mm_from_m(fit_.x.value), y = mm_from_m(fit_.y.value);
        judge("eccentricity",
              fmt::format("eccentricity of the contour against the bore, {:+.3f} and {:+.3f} mm along x and y{}", x, y,
                          percent([&](const InspectionRow& row) {
                              const auto f = factors(row);
                              return f[1] * fit_.x.value + f[2] * fit_.y.value;
                          })),
              std::hypot(x, y), mm_from_m(allowed()), fmt::format("the bore moved by {:+.3f} mm along x and {:+.3f} mm along y", x, y));
    }
    void rotation() {
        const double angle = core::deg_from_rad(fit_.rotation.value);
        const auto share = [&](const InspectionRow& row) { return factors(row)[3] * fit_.rotation.value; };
        judge("rotation", fmt::format("deviation of a contour turned by {:+.3f} deg against the key{}", angle, percent(share)),
              mm_from_m(largest(fit_, [&](std::size_t i) { return share(fit_.rows[i]); })), mm_from_m(allowed()),
              fmt::format("the key cut {:+.3f} deg farther counter-clockwise, or the zero of the shaft set by it", angle));
    }
    void form() {
        const auto [low, high] = std::minmax_element(fit_.form.begin(), fit_.form.end());
        judge("form", "form error of the contour: what offset, eccentricity and rotation leave, peak to peak", mm_from_m(*high - *low),
              mm_from_m(2.0 * allowed()), "another process or finer settings: no compensation removes it");
    }
    void others() {
        for (const InspectionRow& row : sheet_.rows) {
            if (on_contour(row) || std::isnan(row.deviation)) continue;
            const char* id = row.item == Inspected::kBore ? "bore" : row.item == Inspected::kKey ? "key" : "face";
            const bool below = row.deviation < 0.5 * (row.low + row.high);
            const double limit = mm_from_m(below ? row.low : row.high);
            judge(id,
                  fmt::format("deviation of the {}, {:+.3f} mm; allowed {:g} to {:g} mm; the larger of both sides", id,
                              mm_from_m(row.deviation), mm_from_m(row.low), mm_from_m(row.high)),
                  (below ? -1.0 : 1.0) * mm_from_m(row.deviation), (below ? -1.0 : 1.0) * limit,
                  row.item == Inspected::kBore ? "compensation.bore_offset_mm from coupons, or a reamer" : "");
        }
    }
    template <class Share>
    [[nodiscard]] std::string percent(const Share& share) const {
        if (is_rim()) return "";
        return fmt::format(", {:+.2f} % of the arm at most",
                           100.0 * worst_of_arm(fit_, 0.0, [&](std::size_t i) { return share(fit_.rows[i]); }));
    }

    const InspectionSheet& sheet_;
    const Present& present_;
    ContourFit fit_;
    Calibration result_;
};

}  // namespace

ContourFit fit_contour(const InspectionSheet& sheet) {
    std::vector<InspectionRow> rows;
    std::copy_if(sheet.rows.begin(), sheet.rows.end(), std::back_inserter(rows),
                 [](const InspectionRow& row) { return on_contour(row) && !std::isnan(row.deviation); });
    return fitted(std::move(rows));
}

std::string contour_key(const std::string& part) { return kContourKeys[part.starts_with("k_pe") ? 1 : 0]; }

Calibration inspect_contour(const InspectionSheet& sheet, const Present& present) { return Inspector(sheet, present).run(); }

}  // namespace fusee::coupon
