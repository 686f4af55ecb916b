#include "fusee/actuator/noise.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "fusee/actuator/equilibrium.h"
#include "fusee/core/error.h"

// Equation numbers: docs/theory/noise.md.
namespace fusee::actuator {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Names = std::vector<std::string>;

/// A stiffness or rate of decay below this share of the greatest one is rounding.
constexpr double kNothing = 1e-12;
/// Squared rates this close, as a share of the greatest, count as equal: any sum of their shapes is a motion too.
constexpr double kSameRate = 1e-9;

/// A B of small matrices; Eigen's operator * would also compile its kernels for large ones.
template <class A, class B>
auto product(const A& a, const B& b) {
    return a.lazyProduct(b).eval();
}
/// A B A^H.
template <class A, class B>
auto congruent(const A& a, const B& b) {
    return product(product(a, b), a.adjoint());
}

/// A X + X A^T + Q = 0 as one linear system in the entries of X: n^2 unknowns, 36 for a whole joint.
class Lyapunov {
public:
    explicit Lyapunov(const MatrixXd& a) : size_(a.rows()), sums_(sums(a)) {}

    [[nodiscard]] MatrixXd solve(const MatrixXd& q) const {
        const VectorXd entries = sums_.solve(-q.reshaped());
        const MatrixXd x = entries.reshaped(size_, size_);
        return 0.5 * (x + x.transpose());
    }

private:
    /// 1 (x) A + A (x) 1, on the columns of X one below the other.
    static MatrixXd sums(const MatrixXd& a) {
        const Eigen::Index n = a.rows();
        MatrixXd sums = MatrixXd::Zero(n * n, n * n);
        for (Eigen::Index i = 0; i < n; ++i) {
            sums.block(i * n, i * n, n, n) += a;
            for (Eigen::Index j = 0; j < n; ++j) sums.block(i * n, j * n, n, n).diagonal().array() += a(i, j);
        }
        return sums;
    }

    Eigen::Index size_;
    Eigen::PartialPivLU<MatrixXd> sums_;
};

/// M z'' + D z' + K z = w in coordinates y, z = W^T y, W M W^T = 1, and a time in which the fastest spring turns at 1 rad: equally scaled,
/// the Lyapunov equation keeps its digits in any units.
class Motion {
public:
    /// @pre checked matrices
    Motion(const MatrixXd& mass, MatrixXd damping, MatrixXd stiffness)
        : to_unit_mass_(inverse_root(mass)),
          damping_(std::move(damping)),
          stiffness_(std::move(stiffness)),
          shapes_(scaled(stiffness_)),
          rate_(std::sqrt(shapes_.eigenvalues().maxCoeff())),
          lyapunov_(rate_ > 0.0 ? companion(scaled(stiffness_) / (rate_ * rate_), scaled(damping_) / rate_) : MatrixXd::Identity(1, 1)) {}

    /// "noise.unbounded", if noise drives the motion arbitrarily far.
    [[nodiscard]] std::optional<core::Finding> refusal(const Names& names) const {
        if (!(shapes_.eigenvalues()(0) > kNothing * rate_ * rate_))
            return unbounded(names, shapes_.eigenvectors().col(0), stiffness_, "Nm/rad", "no spring to ground holds a motion");
        for (Eigen::Index first = 0, next = 0; first < size(); first = next) {
            const auto& squares = shapes_.eigenvalues();
            while (next < size() && squares(next) - squares(first) <= kSameRate * rate_ * rate_) ++next;
            const MatrixXd shapes = shapes_.eigenvectors().middleCols(first, next - first);
            const Eigen::SelfAdjointEigenSolver<MatrixXd> damped(product(shapes.transpose(), product(scaled(damping_), shapes)));
            if (!(damped.eigenvalues()(0) > 2.0 * kNothing * rate_))  // a motion of damping d decays at d/2
                return unbounded(names, shapes * damped.eigenvectors().col(0), damping_, "Nms/rad", "no damper brakes a motion");
        }
        return std::nullopt;
    }

    /// Covariance of (z, z'). @pre no refusal
    [[nodiscard]] MatrixXd covariance(const MatrixXd& density) const { return to_units(scaled_covariance(density)); }

    /// Its derivative along a change of stiffness: A X' + X' A^T + B X + X B^T = 0, B = dA. @pre no refusal
    [[nodiscard]] MatrixXd covariance_slope(const MatrixXd& density, const MatrixXd& stiffness_change) const {
        MatrixXd change = MatrixXd::Zero(2 * size(), 2 * size());
        change.bottomLeftCorner(size(), size()) = -scaled(stiffness_change) / (rate_ * rate_);
        const MatrixXd moved = product(change, scaled_covariance(density));
        return to_units(lyapunov_.solve(moved + moved.transpose()));
    }

private:
    /// W with W M W^T = 1.
    static MatrixXd inverse_root(const MatrixXd& mass) {
        const Eigen::SelfAdjointEigenSolver<MatrixXd> masses(mass);
        return masses.eigenvalues().cwiseSqrt().cwiseInverse().asDiagonal() * masses.eigenvectors().transpose();
    }
    static MatrixXd companion(const MatrixXd& stiffness, const MatrixXd& damping) {
        const Eigen::Index n = stiffness.rows();
        MatrixXd a(2 * n, 2 * n);
        a << MatrixXd::Zero(n, n), MatrixXd::Identity(n, n), -stiffness, -damping;
        return a;
    }
    [[nodiscard]] Eigen::Index size() const { return to_unit_mass_.rows(); }
    [[nodiscard]] MatrixXd scaled(const MatrixXd& m) const { return congruent(to_unit_mass_, m); }

    [[nodiscard]] MatrixXd scaled_covariance(const MatrixXd& density) const {
        MatrixXd q = MatrixXd::Zero(2 * size(), 2 * size());
        q.bottomRightCorner(size(), size()) = scaled(density) / (rate_ * rate_ * rate_);
        return lyapunov_.solve(q);
    }
    [[nodiscard]] MatrixXd to_units(const MatrixXd& y) const {
        MatrixXd back = MatrixXd::Zero(2 * size(), 2 * size());
        back.topLeftCorner(size(), size()) = to_unit_mass_.transpose();
        back.bottomRightCorner(size(), size()) = rate_ * to_unit_mass_.transpose();
        return congruent(back, y);
    }

    [[nodiscard]] core::Finding unbounded(const Names& names, const VectorXd& shape, const MatrixXd& lacking, const char* unit,
                                          const char* what) const {
        const VectorXd z = to_unit_mass_.transpose() * shape;
        Eigen::Index most = 0;
        const double largest = z.cwiseAbs().maxCoeff(&most);
        // Any value above 0 suffices; a hundredth of the present value at that body changes little else.
        const double present = lacking(most, most), enough = present > 0.0 ? 0.01 * present : 0.01;
        core::Finding finding = core::error_finding("noise.unbounded", fmt::format("{}: noise drives it arbitrarily far", what),
                                                    z.dot(lacking * z) / (largest * largest), core::Bound::kAtLeast, enough, unit);
        for (Eigen::Index i = 0; i < z.size(); ++i)
            finding.where += fmt::format("{}{} {:.3g}", i ? ", " : "motion: ", names[static_cast<std::size_t>(i)], z(i) / z(most));
        finding.suggestion = fmt::format("{:.4g} {} between {} and ground", enough, unit, names[static_cast<std::size_t>(most)]);
        finding.source = "docs/theory/noise.md, eq. 3";
        return finding;
    }

    MatrixXd to_unit_mass_, damping_, stiffness_;
    Eigen::SelfAdjointEigenSolver<MatrixXd> shapes_;  ///< of the springs, in unit masses
    double rate_;                                     ///< [rad/s]
    Lyapunov lyapunov_;
};

/// @throws InvalidInput unless the matrix is square of that size, finite, symmetric, and its least eigenvalue >= 0 (> 0 if `definite`)
void check(const char* name, const MatrixXd& matrix, Eigen::Index size, bool definite = false) {
    const auto refuse = [&](const std::string& value, const std::string& allowed) { throw core::InvalidInput(name, value, allowed); };
    if (size < 1 || matrix.rows() != size || matrix.cols() != size)
        refuse(fmt::format("{} x {}", matrix.rows(), matrix.cols()), "a square matrix of the mass's size");
    if (!matrix.allFinite()) refuse("not finite", "finite entries");
    const double scale = matrix.cwiseAbs().maxCoeff();
    if (!((matrix - matrix.transpose()).cwiseAbs().maxCoeff() <= kNothing * scale)) refuse("not symmetric", "a symmetric matrix");
    const double least = Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues()(0);
    if (definite && !(least > 0.0)) refuse(fmt::format("eigenvalue {:.4g}", least), "positive definite");
    if (!(least >= -kNothing * scale)) refuse(fmt::format("eigenvalue {:.4g}", least), "positive semidefinite");
}

void require_not_negative(const char* name, double value, const char* unit) {
    core::require_within(name, value, 0.0, std::numeric_limits<double>::max(), unit);
}

/// Figure 1 as matrices.
struct PathMatrices {
    explicit PathMatrices(const NoisePath& path) {
        for (const auto& [name, value] : {std::pair{"a", path.a}, {"b", path.b}, {"c", path.c}})
            require_not_negative(name, value, "Nm/rad");
        for (const auto& [name, value] : {std::pair{"d", path.d}, {"e", path.e}}) require_not_negative(name, value, "Nms/rad");
        core::require_positive("motor_inertia", path.motor_inertia, "kg m^2");
        core::require_positive("joint_inertia", path.joint_inertia, "kg m^2");
        require_not_negative("motor_noise", path.motor_noise, "(Nm)^2 s");
        require_not_negative("joint_noise", path.joint_noise, "(Nm)^2 s");
        mass << path.motor_inertia, 0.0, 0.0, path.joint_inertia;
        damping << path.d, 0.0, 0.0, path.e;
        stiffness << path.a + path.c, -path.c, -path.c, path.b + path.c;
        density << path.motor_noise, 0.0, 0.0, path.joint_noise;
    }
    [[nodiscard]] Motion motion() const { return {mass, damping, stiffness}; }
    static Names names() { return {"motor", "joint"}; }

    Eigen::Matrix2d mass, damping, stiffness, density;
};

}  // namespace

core::Outcome<MatrixXd> stationary_covariance(const MatrixXd& mass, const MatrixXd& damping, const MatrixXd& stiffness,
                                              const MatrixXd& density) {
    check("mass", mass, mass.rows(), true);
    check("damping", damping, mass.rows());
    check("stiffness", stiffness, mass.rows());
    check("density", density, mass.rows());
    Names names;
    for (Eigen::Index i = 0; i < mass.rows(); ++i) names.push_back(fmt::format("z[{}]", i));
    const Motion motion(mass, damping, stiffness);
    if (auto refusal = motion.refusal(names)) return *std::move(refusal);
    return motion.covariance(density);
}

core::Outcome<NoiseResponse> passive_noise(const NoisePath& path) {
    const PathMatrices matrices(path);
    const Motion motion = matrices.motion();
    if (auto refusal = motion.refusal(PathMatrices::names())) return *std::move(refusal);
    NoiseResponse response;
    response.covariance = motion.covariance(matrices.density);
    response.motor_variance = response.covariance(0, 0);
    response.joint_variance = response.covariance(1, 1);
    return response;
}

core::Outcome<double> joint_variance_slope(const NoisePath& path) {
    const PathMatrices matrices(path);
    const Motion motion = matrices.motion();
    if (auto refusal = motion.refusal(PathMatrices::names())) return *std::move(refusal);
    const Eigen::Vector2d jacobian_row(1.0, -1.0);  // of the spring c
    return motion.covariance_slope(matrices.density, jacobian_row * jacobian_row.transpose())(1, 1);
}

core::Outcome<Eigen::Vector3d> joint_noise(const Joint& joint, double tau, const NoiseOptions& options) {
    core::require_positive("motor_inertia", options.motor_inertia, "kg m^2");
    core::require_positive("joint_inertia", options.joint_inertia, "kg m^2");
    require_not_negative("motor_viscous", options.motor_viscous, "Nms/rad");
    require_not_negative("joint_viscous", options.joint_viscous, "Nms/rad");
    require_not_negative("motor_noise", options.motor_noise, "(Nm)^2 s");
    require_not_negative("joint_noise", options.joint_noise, "(Nm)^2 s");
    const auto rest = find_equilibrium(joint, {tau, tau, 0.0});
    if (!rest) return rest.refusal();

    std::vector<Eigen::Index> free;
    Names names;
    for (const auto& [body, name] : {std::pair{kAgonist, "capstan 1"}, {kAntagonist, "capstan 2"}, {kOutput, "output"}})
        if (!joint.frozen[static_cast<std::size_t>(body)]) free.push_back(body), names.emplace_back(name);
    const auto diagonal = [&](double motor, double output) -> MatrixXd { return Eigen::Vector3d(motor, motor, output)(free).asDiagonal(); };
    const MatrixXd stiff = stiffness(joint, rest->z)(free, free);
    const Motion motion(diagonal(options.motor_inertia, options.joint_inertia), diagonal(options.motor_viscous, options.joint_viscous),
                        stiff);
    if (auto refusal = motion.refusal(names)) return *std::move(refusal);
    const MatrixXd covariance = motion.covariance(diagonal(options.motor_noise, options.joint_noise));
    Eigen::Vector3d deviation = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < free.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        deviation(free[i]) = std::sqrt(std::max(0.0, covariance(at, at)));
    }
    return deviation;
}

}  // namespace fusee::actuator
