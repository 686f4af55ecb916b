#include "swept.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>

namespace fusee::assembly {

namespace {

using Eigen::Isometry3d, Eigen::Vector3d;

constexpr int kMostBoxes = 3000;         // of one pair
constexpr double kSampleBand_mm = 0.05;  // a proof this near to the least distance is enough
constexpr double kMostTurn_mm = 1.0;     // of a point: farther turns are taken as discs

/// Turn and payout of the agonist, then of the antagonist: from least to most.
struct PoseBox {
    std::array<core::Range, 4> of;
    double bound_mm = 0.0;
    [[nodiscard]] Pose at(const std::array<double, 4>& v) const { return {{v[0], v[1]}, {v[2], v[3]}}; }
    [[nodiscard]] Pose low() const { return at({of[0].low, of[1].low, of[2].low, of[3].low}); }
    [[nodiscard]] Pose high() const { return at({of[0].high, of[1].high, of[2].high, of[3].high}); }
    [[nodiscard]] Pose middle() const {
        std::array<double, 4> v{};
        for (std::size_t i = 0; i < v.size(); ++i) v[i] = 0.5 * (of[i].low + of[i].high);
        return at(v);
    }
    [[nodiscard]] bool operator<(const PoseBox& other) const { return bound_mm > other.bound_mm; }  // the least first
};

std::size_t first_of(const Body& body) { return body.side == Side::kAntagonist ? 2 : 0; }
bool slides(const Body& body) { return body.motion == Motion::kCarriage || body.motion == Motion::kSpool; }
bool turns(const Body& body) { return body.motion == Motion::kCapstan || body.motion == Motion::kSpool || body.motion == Motion::kJoint; }
double body_reach_mm(const Body& body) {
    double reach = 0.0;
    for (const Prism& prism : body.prisms)
        for (const solid::Point2& p : prism.outline_mm) reach = std::max(reach, std::hypot(p[0], p[1]));
    return reach;
}

/// Largest angle by which a cam turns in a box from its middle pose [rad].
double turn_from_middle(const Assembly& a, const Body& cam, const PoseBox& box) {
    const std::size_t first = first_of(cam);
    if (cam.motion == Motion::kCapstan) return 0.5 * box.of[first].width();
    const core::Range& payout = box.of[first + 1];
    const double low = spool_angle(a, payout.low), middle = spool_angle(a, 0.5 * (payout.low + payout.high)),
                 high = spool_angle(a, payout.high);
    return std::max(high - middle, middle - low);
}

/// Between the placements of two poses a body only slides, along a straight line; its turn is that of the middle pose, or a disc.
Enclosure enclose(const Assembly& a, const Body& body, const PoseBox& box) {
    Enclosure all;
    const bool round = body.cam == nullptr;  // about its axis: drums, shafts, rings, the joint's pulley with its pin
    bool disc = turns(body) && round;
    if (turns(body) && !round) {
        all.loss_mm = turn_from_middle(a, body, box) * body_reach_mm(body);
        if (all.loss_mm > kMostTurn_mm) disc = true, all.loss_mm = 0.0;
    }
    const Isometry3d middle = placement(a, body, box.middle()), low = placement(a, body, box.low()), high = placement(a, body, box.high());
    for (const Prism& prism : body.prisms) {
        const Prism here = placed(disc ? disc_around(prism) : prism, middle);
        all.prisms.push_back(hull_between(here, low.translation() - middle.translation(), high.translation() - middle.translation()));
    }
    return all;
}

double enclosure_distance(const Enclosure& one, const Enclosure& other, double most_mm) {
    const double loss = one.loss_mm + other.loss_mm;
    double least = most_mm + loss;
    for (const Prism& p : one.prisms)
        for (const Prism& q : other.prisms) least = distance_mm(p, q, least);
    return least - loss;
}

/// The pair's motion: bodies of one carriage do not slide against each other.
struct Pair {
    const Assembly& a;
    const Body &one, &other;
    [[nodiscard]] bool carried() const { return slides(one) && slides(other) && one.side == other.side; }
    [[nodiscard]] PoseBox whole() const {
        const core::Range turn{0.0, a.greatest_turn}, payout{0.0, a.greatest_payout_mm}, none{0.0, 0.0};
        PoseBox box{{none, none, none, none}};
        for (const Body* body : {&one, &other}) {
            if (body->motion == Motion::kFixed || body->motion == Motion::kJoint) continue;
            const std::size_t first = first_of(*body);
            if (!carried()) box.of[first] = turn;
            if (body->motion == Motion::kSpool) box.of[first + 1] = payout;
        }
        return box;
    }
    [[nodiscard]] double bound(const PoseBox& box, double most_mm) const {
        return enclosure_distance(enclose(a, one, box), enclose(a, other, box), most_mm);
    }
    /// Distance of the bodies in a pose, without loss.
    [[nodiscard]] double sample(const Pose& pose, double most_mm) const {
        const std::array<double, 4> v{pose.agonist.turn, pose.agonist.payout_mm, pose.antagonist.turn, pose.antagonist.payout_mm};
        PoseBox point;
        for (std::size_t i = 0; i < v.size(); ++i) point.of[i] = {v[i], v[i]};
        return bound(point, most_mm);
    }
    /// The variable that moves the bodies farthest in a box.
    [[nodiscard]] std::size_t widest(const PoseBox& box) const {
        std::array<double, 4> ways{};
        for (const Body* body : {&one, &other}) {
            const std::size_t first = first_of(*body);
            const bool cam = body->cam != nullptr;
            if (body->motion == Motion::kCapstan && cam) ways[first] += box.of[first].width() * body_reach_mm(*body);
            if (slides(*body) || body->motion == Motion::kSpringEnd) ways[first] += box.of[first].width() * a.capstan_radius_mm;
            if (body->motion == Motion::kSpool && cam) ways[first + 1] += 2.0 * turn_from_middle(a, *body, box) * body_reach_mm(*body);
        }
        return static_cast<std::size_t>(std::max_element(ways.begin(), ways.end()) - ways.begin());
    }
};

}  // namespace

bool is_proven(const Gap& gap, double enough_mm) {
    constexpr double kRounding_mm = 1e-9;
    return gap.proven_mm + kRounding_mm >= std::min(enough_mm, gap.mm - kSampleBand_mm);
}

double WholeRange::bound_mm(const Body& one, const Body& other, double most_mm) {
    const PoseBox whole = Pair{a_, one, other}.whole();
    const auto around = [&](const Body& body) -> const Enclosure& {
        std::array<double, 4> ends{};
        for (std::size_t i = 0; i < ends.size(); ++i)
            if (body.motion == Motion::kJoint || i / 2 == first_of(body) / 2) ends[i] = whole.of[i].high;
        const auto [place, is_new] = known_.try_emplace({&body, ends});
        if (is_new) place->second = enclose(a_, body, whole);
        return place->second;
    };
    return enclosure_distance(around(one), around(other), most_mm);
}

void prove(const Assembly& a, const Body& one, const Body& other, double enough_mm, Gap& gap) {
    const Pair pair{a, one, other};
    const auto aim = [&] { return std::min(enough_mm, gap.mm - kSampleBand_mm); };
    std::priority_queue<PoseBox> open;
    PoseBox whole = pair.whole();
    whole.bound_mm = pair.bound(whole, enough_mm);
    open.push(whole);
    for (int boxes = 0; open.top().bound_mm < aim() && boxes < kMostBoxes; boxes += 2) {
        const PoseBox box = open.top();
        open.pop();
        const std::size_t at = pair.widest(box);
        const double half = 0.5 * (box.of[at].low + box.of[at].high);
        for (const bool upper : {false, true}) {
            PoseBox part = box;
            (upper ? part.of[at].low : part.of[at].high) = half;
            part.bound_mm = std::max(box.bound_mm, pair.bound(part, enough_mm));  // what holds for a box holds for its parts
            if (const double mm = pair.sample(part.middle(), gap.mm); mm < gap.mm) gap.mm = std::max(mm, 0.0), gap.pose = part.middle();
            open.push(part);
        }
    }
    gap.proven_mm = std::max(std::min(open.top().bound_mm, gap.mm), 0.0);
}

}  // namespace fusee::assembly
