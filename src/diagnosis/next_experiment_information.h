#pragma once
#include <Eigen/Core>
#include <span>

namespace fusee::diagnosis {

/// -sum p log2 p [bit] of probabilities that sum to 1.
[[nodiscard]] double entropy(std::span<const double> probabilities);

/// Expected information of an outcome on which hypothesis is true [bit], between 0 and their entropy. Outcomes are Gaussian
/// with a common covariance; `distances` holds the squared distances of their means in it. Two hypotheses: exact, by quadrature along the
/// line between the means, the only relevant direction. More: the lower bound -sum_i p_i log2 sum_j p_j exp(-D_ij^2/8) (Kolchinsky
/// and Tracey, Entropy 19, 361, 2017, eq. 10 with Bhattacharyya's distance).
/// @pre probabilities sum to 1; `distances` is symmetric, 0 on the diagonal
[[nodiscard]] double expected_information(std::span<const double> probabilities, const Eigen::MatrixXd& distances);

}  // namespace fusee::diagnosis
