#include <Eigen/Dense>
#include <cmath>

#include "fusee/core/file.h"
#include "fusee/pipeline/evaluate.h"
#include "one_spring/changed_law.h"
#include "pipeline/fixture.h"

// The repair of a law against a peer that repairs by another way: it moves the arms of a roller on a slide on the points of the law, by
// Levenberg-Marquardt steps under a penalty that grows. It has the same spring, base radius and roller, and fewer limits: the curvature of
// the roller centre's curve alone. It shares no code with the program.
namespace fusee::search::one_spring {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

struct Peer {
    double rate, preload, start, sharpest, step;  ///< [N/m], [m], of the roller's centre [m], its least radius of curvature [m], [rad]
    VectorXd wanted;                              ///< [Nm]

    [[nodiscard]] VectorXd lifts(const VectorXd& arms) const {
        VectorXd y = VectorXd::Zero(arms.size());
        for (Eigen::Index i = 1; i < arms.size(); ++i) y[i] = y[i - 1] + 0.5 * step * (arms[i] + arms[i - 1]);
        return y;
    }
    [[nodiscard]] VectorXd torques(const VectorXd& arms) const { return rate * (lifts(arms).array() + preload) * arms.array(); }
    /// Curvature times `sharpest`, w/L of docs/theory/roller.md, eq. 4, between two points: within 0 and 1.
    [[nodiscard]] VectorXd curvatures(const VectorXd& arms) const {
        const VectorXd y = lifts(arms);
        VectorXd all(arms.size() - 1);
        for (Eigen::Index i = 0; i < all.size(); ++i) {
            const double r = 0.5 * (arms[i] + arms[i + 1]), slope = (arms[i + 1] - arms[i]) / step, s = start + 0.5 * (y[i] + y[i + 1]);
            const double squared = s * s + r * r;
            all[i] = sharpest * (squared + r * r - s * slope) / std::pow(squared, 1.5);
        }
        return all;
    }
    /// What is least in squares: the change over the largest torque, and what lies beyond a limit times `price`.
    [[nodiscard]] VectorXd residuals(const VectorXd& arms, double price) const {
        const VectorXd bend = curvatures(arms);
        VectorXd all(wanted.size() + bend.size());
        all.head(wanted.size()) = (torques(arms) - wanted) / wanted.cwiseAbs().maxCoeff();
        for (Eigen::Index i = 0; i < bend.size(); ++i)
            all[wanted.size() + i] = price * (std::max(0.0, bend[i] - 1.0) + std::min(0.0, bend[i]));
        return all;
    }
    [[nodiscard]] MatrixXd derivative(const VectorXd& arms, double price) const {
        constexpr double kStep = 1e-9;
        const VectorXd at = residuals(arms, price);
        MatrixXd all(at.size(), arms.size());
        for (Eigen::Index k = 0; k < arms.size(); ++k) {
            VectorXd moved = arms;
            moved[k] += kStep;
            all.col(k) = (residuals(moved, price) - at) / kStep;
        }
        return all;
    }
    [[nodiscard]] VectorXd nearest_arms() const {
        VectorXd arms(wanted.size());
        double energy = 0.5 * rate * preload * preload;
        for (Eigen::Index i = 0; i < wanted.size(); ++i) {
            if (i > 0) energy += 0.5 * step * (wanted[i] + wanted[i - 1]);
            arms[i] = wanted[i] / std::sqrt(2.0 * rate * energy);
        }
        for (double price = 0.1; price < 2e4; price *= 10.0) {
            double damping = 1e-3;
            for (int i = 0; i < 12; ++i) {
                const VectorXd at = residuals(arms, price);
                const MatrixXd j = derivative(arms, price), square = j.transpose() * j;
                MatrixXd left = square;
                left.diagonal() += damping * square.diagonal();
                const VectorXd next = arms - left.ldlt().solve(j.transpose() * at);
                const bool better = residuals(next, price).squaredNorm() < at.squaredNorm();
                damping *= better ? 0.3 : 10.0;
                if (better) arms = next;
            }
        }
        return arms;
    }
};

class RepairPeer : public fixtures::TempFolder {};

/// The shipped balance with a step that its rim cannot follow.
TEST_F(RepairPeer, ChangesTheLawNoLess) {
    std::string text = core::read_file(fixtures::shipped("single/gravity_balance"));
    const std::size_t law = text.find("kind = \"gravity\""), end = text.find("[process]");
    text.replace(law, end - law, "kind = \"formula\"\nformula_Nm = \"0.6+0.35*tanh(25*x)\"\nfrom_deg = -35.0\nto_deg = 35.0\n\n");
    const profile::Profile asked = profile::read_profile(write("step.toml", text));
    const Task task = task_of(asked).value();
    const std::vector<double> wanted = points_of(task);
    const auto holds = [&](const std::vector<double>& points) {
        return pipeline::evaluate(with_law(asked, task, points), pipeline::Depth::kOutline).passed();
    };
    ASSERT_FALSE(holds(wanted)) << "the law needs no repair";
    double width = 0.01;
    while (width < 0.3 && !holds(points_of(changed_task(task, {.width = width})))) width *= 1.1;
    const std::vector<double> smooth = points_of(changed_task(task, {.width = width}));
    ASSERT_TRUE(holds(smooth));
    const std::vector<double> nearest = nearest_points(with_law(asked, task, smooth), wanted, holds);
    EXPECT_TRUE(holds(nearest));

    constexpr double kUndercut = 1.1;  // roller.undercut, required
    const profile::PartSpec& spec = asked.k_pe;
    Peer peer{spec.spring.rate,
              spec.spring.preload,
              spec.cam.roller.base_radius + spec.cam.roller.radius,
              kUndercut * spec.cam.roller.radius,
              task.travel / static_cast<double>(wanted.size() - 1),
              {}};
    peer.wanted = Eigen::Map<const VectorXd>(wanted.data(), static_cast<Eigen::Index>(wanted.size()));
    const VectorXd arms = peer.nearest_arms(), bend = peer.curvatures(arms), torques = peer.torques(arms);
    EXPECT_GT(bend.minCoeff(), -0.01);
    EXPECT_LT(bend.maxCoeff(), 1.01);
    const double ours = distance(nearest, wanted) / task.torque, first = distance(smooth, wanted) / task.torque,
                 of_peer = distance({torques.data(), torques.data() + torques.size()}, wanted) / task.torque;
    RecordProperty("repair_percent", std::to_string(100.0 * ours));
    RecordProperty("peer_percent", std::to_string(100.0 * of_peer));
    EXPECT_LT(ours, 1.05 * of_peer) << "of the largest torque: " << ours << " and " << of_peer << ", by the Gaussian alone " << first;
    EXPECT_GT(ours, 0.9 * of_peer) << "the peer has found no near law";
}

}  // namespace
}  // namespace fusee::search::one_spring
