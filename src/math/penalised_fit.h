#pragma once
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace fusee::math {

/// Least squares on rows of B-splines B with a penalty on the third differences D of the coefficients: solves [B; sqrt(lambda) D] c = [y;
/// 0]. Immutable and reentrant.
class PenalisedFit {
public:
    static constexpr int kDegree = 5;
    /// A row of the data: index of the first spline that is not 0 there, the values of the splines, and the measurement.
    struct Row {
        std::size_t first = 0;
        std::array<double, kDegree + 1> values{};
        double y = 0.0;
    };
    struct Result {
        std::vector<double> coefficients;
        double residual = 0.0;    ///< sum of squares
        double parameters = 0.0;  ///< trace of the smoother
        /// The robust score of cross-validation, see SmoothingSpline.
        [[nodiscard]] double score(double rows) const;
    };

    PenalisedFit(std::size_t rows, double scale) : rows_(static_cast<double>(rows)), scale_(scale) {}
    virtual ~PenalisedFit() = default;
    /// @pre lambda >= 0
    [[nodiscard]] virtual Result solve(double lambda) const = 0;
    /// The weight with the best score: a coarse scan (the score may have several minima), then Brent's method at the best one.
    [[nodiscard]] double choose_lambda() const;

protected:
    double rows_;
    double scale_;  ///< the weight that balances data and penalty
};

/// @pre rows sorted by `first`, of splines below `count`; count >= 4
/// Dense and rank-revealing up to some thousand rows, O(rows count^2) for each weight; beyond, by a banded QR, O(rows + count^2).
[[nodiscard]] std::unique_ptr<const PenalisedFit> make_penalised_fit(const std::vector<PenalisedFit::Row>& rows, std::size_t count);
/// One of the two, for any size.
[[nodiscard]] std::unique_ptr<const PenalisedFit> make_dense_fit(const std::vector<PenalisedFit::Row>& rows, std::size_t count);
[[nodiscard]] std::unique_ptr<const PenalisedFit> make_banded_fit(const std::vector<PenalisedFit::Row>& rows, std::size_t count);

}  // namespace fusee::math
