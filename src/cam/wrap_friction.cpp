#include "fusee/cam/wrap_friction.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/error.h"
#include "fusee/core/lists.h"

namespace fusee::cam {

namespace {

constexpr int kIdlePieces = 200;  // from the anchor to the first contact

/// Pieces of the wrap between two directions of the normal.
void lay_between(WrappedCable& cable, const Cam& cam, double from, double to, int count, double tension) {
    const double step = (to - from) / count;
    for (int i = 0; i < count; ++i) cable.lay(std::abs(step), cam.path(from + (i + 0.5) * step).rho * std::abs(step), tension);
}

/// The cable around the cam while the tension rises and falls once.
class Cycle {
public:
    Cycle(const Cam& cam, const WrapFriction& friction)
        : cam_(cam), winds_(cam.kind == PartKind::kParallel), cable_(friction.friction, friction.stiffness) {
        // K_PE starts with the least wound cable, K_SE with the most.
        double psi = near(cam.anchor_psi, front().psi);
        const double tension = cam.working.front().arm.tension;
        lay_between(cable_, cam, psi, (winds_ ? front() : back()).psi, kIdlePieces, tension);
        if (winds_) return;
        for (std::size_t i = cam.working.size() - 1; i > 0; --i) lay_between(cable_, cam, at(i).psi, at(i - 1).psi, 1, tension);
    }

    /// One direction; sets the elongation of the rows.
    void run(bool loading, std::vector<double>& elongation) {
        const std::size_t count = cam_.working.size();
        elongation.resize(count);
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t i = loading ? k : count - 1 - k;
            const double tension = cam_.working[i].arm.tension;
            if (k > 0) step(loading ? i - 1 : i + 1, i, tension);
            cable_.pull(tension);
            elongation[i] = cable_.elongation();
        }
    }
    [[nodiscard]] double dissipated() const { return cable_.dissipated(); }

private:
    [[nodiscard]] const PathPoint& at(std::size_t i) const { return cam_.working[i].path; }
    [[nodiscard]] const PathPoint& front() const { return at(0); }
    [[nodiscard]] const PathPoint& back() const { return at(cam_.working.size() - 1); }
    /// The anchor's direction, shifted by whole turns to the wound side of the contact.
    [[nodiscard]] double near(double anchor, double contact) const {
        const double turn = 2.0 * core::kPi;
        if (!cam_.closed()) return anchor;
        const int side = cam_.options.torque_sign;  // the cable leaves towards rising psi for +1, and is wound below
        while (side * (contact - anchor) < 0.0) anchor -= side * turn;
        while (side * (contact - anchor) > turn) anchor += side * turn;
        return anchor;
    }
    void step(std::size_t from, std::size_t to, double tension) {
        if ((to > from) == winds_)
            lay_between(cable_, cam_, at(from).psi, at(to).psi, 1, tension);
        else
            cable_.unlay();
    }

    const Cam& cam_;
    bool winds_;
    WrappedCable cable_;
};

}  // namespace

WrappedCable::WrappedCable(double friction, double stiffness)
    : friction_(core::require_within("cable.friction", friction, 0.0, 10.0)),
      stiffness_(core::require_positive("cable.stiffness_N", stiffness, "N")) {}

void WrappedCable::lay(double turn, double length, double tension) { pieces_.push_back({turn, length, tension}); }

void WrappedCable::pull(double tension) {
    double to_middle = 0.0, moved = 0.0;
    auto before = core::each<double>(pieces_, &Piece::tension);
    for (auto p = pieces_.rbegin(); p != pieces_.rend(); ++p) {
        const double held = std::exp(friction_ * (to_middle + 0.5 * p->turn));
        to_middle += p->turn;
        p->tension = std::clamp(p->tension, tension / held, tension * held);
    }
    // Slip at a piece's outer end is the additional elongation of all pieces inside it. Friction there is the step of the tension, taken
    // from its mean.
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const double change = pieces_[i].tension - before[i];
        moved += 0.5 * change * pieces_[i].length / stiffness_;
        dissipated_ += friction_ * pieces_[i].turn * 0.5 * (pieces_[i].tension + before[i]) * std::abs(moved);
        moved += 0.5 * change * pieces_[i].length / stiffness_;
    }
}

double WrappedCable::elongation() const {
    double sum = 0.0;
    for (const Piece& p : pieces_) sum += p.tension * p.length;
    return sum / stiffness_;
}

WrapLoop wrap_loop(const Cam& cam, double rate, double capstan_radius, const WrapFriction& friction) {
    Cycle cycle(cam, friction);
    std::vector<double> up, down;
    double before = 0.0;
    for (int round = 0; round < 2; ++round) {  // the second one repeats: every piece has slipped or will never slip
        before = cycle.dissipated();
        cycle.run(true, up);
        cycle.run(false, down);
    }
    WrapLoop loop;
    loop.dissipated = cycle.dissipated() - before;
    for (std::size_t i = 0; i < cam.working.size(); ++i) {
        const ArmPoint& arm = cam.working[i].arm;
        const double stiffness = arm.tension * arm.slope + rate * arm.arm * arm.arm;  // P of K_PE
        const double deflection = cam.kind == PartKind::kSeries ? 1.0 / capstan_radius : rate * arm.arm / stiffness;
        loop.rows.push_back({arm.angle, arm.tau, arm.tension, up[i], down[i], deflection * up[i], deflection * down[i]});
    }
    return loop;
}

}  // namespace fusee::cam
