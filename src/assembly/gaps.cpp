#include "gaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <set>

#include "fusee/core/lists.h"

namespace fusee::assembly {

namespace {

using Eigen::Isometry3d;

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

/// What holds a body in every pose of a box, once each prism is wider by `loss_mm`.
struct Enclosure {
    std::vector<Prism> prisms;
    double loss_mm = 0.0;
};

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

/// Bounds of pairs over the whole range as one box. What holds a body there is found once for all its partners.
class WholeRange {
public:
    explicit WholeRange(const Assembly& assembly) : a_(assembly) {}
    /// `most_mm` if it is that much or more
    [[nodiscard]] double bound_mm(const Body& one, const Body& other, double most_mm) {
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

private:
    const Assembly& a_;
    std::map<std::pair<const Body*, std::array<double, 4>>, Enclosure> known_;  ///< by the ends of the ranges that move the body
};

/// Proves a distance of two bodies over every pose of the working range, not only at samples. The range is cut into boxes; in each, a body
/// that slides is taken as the hull of all its places, one that turns as the disc around it, or, where it turns by little, in its middle
/// pose with its distance less the way of its farthest point. Boxes whose bound is below the aim are halved. `gap` holds the sampled least
/// distance on entry; its distance and pose are lowered where a middle pose is nearer, and `proven_mm` is set.
/// @param enough_mm proofs beyond it are not sought
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

using Names = std::set<std::string>;

constexpr double kNear_mm = 10.0;

/// Bodies that touch by design, by their names without the side.
const std::set<Names> kContacts{{"axle", "carriage"},
                                {"axle", "axle_sleeve"},
                                {"axle_rings", "axle_sleeve"},
                                {"axle_rings", "carriage"},
                                {"axle_rings", "k_se"},
                                {"axle_rings", "k_se_spring"},
                                {"joint_pulley", "joint_stops"},
                                {"stop_pin", "joint_stops"},
                                {"capstan_pin", "capstan_stops"},
                                {"carriage", "rods"},
                                {"bushes", "rods"},
                                {"k_se_spring", "axle"},
                                {"k_se_spring", "k_se"},
                                {"k_se_spring", "leg_in_k_se"},
                                {"k_se_spring", "spring_arbor"},
                                {"k_pe_cap", "k_pe_spring"},
                                {"k_pe_seat", "k_pe_spring"}};
/// What each cable touches.
const std::array<Names, 3> kTouched{Names{"capstan", "capstan_pin", "carriage", "frame_rear"},
                                    Names{"k_se", "carriage", "joint_pulley", "stop_pin", "frame_front"},
                                    Names{"k_pe", "k_pe_seat", "k_pe_spring", "k_pe_cap", "k_pe_posts"}};

/// The motions that a body's place depends on: turn and payout of its side.
struct Moves {
    std::array<bool, 4> by{};  ///< agonist's turn, agonist's payout, antagonist's turn, antagonist's payout
    void add(const Body& body) {
        if (body.motion == Motion::kFixed || body.motion == Motion::kJoint) return;  // the pulley is round
        const std::size_t first = body.side == Side::kAntagonist ? 2 : 0;
        by[first] = true;
        if (body.motion == Motion::kSpool) by[first + 1] = true;
    }
};

/// Calls `take` with poses that cover the motions.
void each_pose(const Assembly& a, const Moves& moves, const std::function<void(const Pose&)>& take) {
    const auto motions = std::count(moves.by.begin(), moves.by.end(), true);
    const int samples = motions <= 1 ? 33 : motions == 2 ? 13 : motions == 3 ? 7 : 5;
    std::array<int, 4> at{};
    const auto value = [&](std::size_t i, double most) { return most * at[i] / (samples - 1.0); };
    for (std::size_t i = 0; i < at.size();) {
        take({{value(0, a.greatest_turn), value(1, a.greatest_payout_mm)}, {value(2, a.greatest_turn), value(3, a.greatest_payout_mm)}});
        for (i = 0; i < at.size(); ++i) {  // the next one: counts like digits
            if (!moves.by[i]) continue;
            if (++at[i] < samples) break;
            at[i] = 0;
        }
    }
}

/// A circle around a body in the plane, and its prisms, in its own frame.
struct Round {
    const Body& body;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    double radius_mm = 0.0;
    explicit Round(const Body& b) : body(b) {
        std::array<double, 2> low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
        for (const Prism& prism : b.prisms)
            for (const solid::Point2& p : prism.outline_mm)
                for (std::size_t k = 0; k < 2; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
        middle = {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.0};
        radius_mm = 0.5 * std::hypot(high[0] - low[0], high[1] - low[1]);
    }
    [[nodiscard]] Eigen::Vector2d middle_at(const Eigen::Isometry3d& at) const { return (at * middle).head<2>(); }
};

std::vector<Prism> placed_all(const Body& body, const Eigen::Isometry3d& at) {
    return core::each<Prism>(body.prisms, [&](const Prism& prism) { return placed(prism, at); });
}

double distance(const Assembly& a, const Round& one, const Round& other, const Pose& pose, double most_mm) {
    const Eigen::Isometry3d at_one = placement(a, one.body, pose), at_other = placement(a, other.body, pose);
    const double apart = (one.middle_at(at_one) - other.middle_at(at_other)).norm() - one.radius_mm - other.radius_mm;
    if (apart >= most_mm) return most_mm;
    double least = most_mm;
    const std::vector<Prism> others = placed_all(other.body, at_other);
    for (const Prism& p : placed_all(one.body, at_one))
        for (const Prism& q : others) least = distance_mm(p, q, least);
    return least;
}

/// Does the frame hold a body, or turn a shaft in a bearing? What it passes by, such as a carriage, is judged.
bool held(const Body& a, const Body& b) {
    static const Names kHeld{"rods", "motor_shaft", "joint_shaft"};
    static const Names kFrame{"frame_plate", "frame_front", "frame_rear", "joint_tower", "k_pe_posts", "bearings", "joint_shaft"};
    if (!kFrame.contains(a.name)) return kFrame.contains(b.name) && held(b, a);
    return (a.motion == Motion::kFixed && b.motion == Motion::kFixed) || kHeld.contains(b.base_name()) ||
           (a.name == "joint_shaft" && (b.name == "joint_pulley" || kFrame.contains(b.name)));
}

bool may_meet(const Body& a, const Body& b) {
    if (held(a, b)) return false;
    if (a.side == Side::kAntagonist || (a.side == b.side && a.motion == b.motion && a.motion != Motion::kFixed)) return false;
    return b.side == Side::kAntagonist || !kContacts.contains({a.base_name(), b.base_name()});
}

bool touches(const FreeCable& cable, const Body& body) {
    return body.side != Side::kAntagonist && kTouched.at(static_cast<std::size_t>(cable.kind)).contains(body.base_name());
}

std::string name_of(const FreeCable& cable) { return std::string(to_string(cable.kind)) + " cable, " + to_string(cable.side); }

/// Distance of a straight cable and a point, seen along z.
double apart_mm(const FreeCable& cable, const Eigen::Vector2d& point) {
    const Eigen::Vector2d from = cable.from_mm.head<2>(), along = cable.to_mm.head<2>() - from;
    const double share = std::clamp(along.dot(point - from) / along.squaredNorm(), 0.0, 1.0);
    return (from + share * along - point).norm();
}

void sort(std::vector<Gap>& gaps) {
    std::erase_if(gaps, [](const Gap& gap) { return gap.mm >= kNear_mm; });
    std::stable_sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) { return a.mm < b.mm; });
}

}  // namespace

bool is_proven(const Gap& gap, double enough_mm) {
    constexpr double kRounding_mm = 1e-9;
    return gap.proven_mm + kRounding_mm >= std::min(enough_mm, gap.mm - kSampleBand_mm);
}

std::vector<Gap> body_gaps(const Assembly& a, double enough_mm) {
    std::vector<Gap> gaps;
    WholeRange range(a);
    for (std::size_t i = 0; i < a.bodies.size(); ++i)
        for (std::size_t j = i + 1; j < a.bodies.size(); ++j) {
            const Body &one = a.bodies[i].side == Side::kAntagonist ? a.bodies[j] : a.bodies[i],
                       &other = &one == &a.bodies[i] ? a.bodies[j] : a.bodies[i];
            if (!may_meet(one, other) || range.bound_mm(one, other, kNear_mm) >= kNear_mm) continue;
            Moves moves;
            moves.add(one), moves.add(other);
            const auto carried = [](const Body& body) { return body.motion == Motion::kCarriage || body.motion == Motion::kSpool; };
            if (carried(one) && carried(other) && one.side == other.side) moves.by[0] = false;  // the carriage carries both
            const Round around_one(one), around_other(other);
            Gap gap{one.name, other.name, kNear_mm, 0.0, {}};
            each_pose(a, moves, [&](const Pose& pose) {
                const double mm = distance(a, around_one, around_other, pose, gap.mm);
                if (mm < gap.mm) gap.mm = mm, gap.pose = pose;
            });
            prove(a, one, other, enough_mm, gap);
            gaps.push_back(std::move(gap));
        }
    sort(gaps);
    return gaps;
}

std::vector<Gap> cable_gaps(const Assembly& a) {
    std::vector<Gap> gaps;
    std::map<std::array<double, 2>, std::vector<FreeCable>> known;  // by the agonist's pose, which the agonist's cables follow
    for (const Body& body : a.bodies) {
        const Round around(body);
        std::map<CableKind, Gap> of_body;
        Moves moves{{true, true, false, false}};
        moves.add(body);
        each_pose(a, moves, [&](const Pose& pose) {
            const Eigen::Isometry3d at = placement(a, body, pose);
            std::vector<Prism> prisms;
            const auto [cables, is_new] = known.try_emplace({pose.agonist.turn, pose.agonist.payout_mm});
            if (is_new) cables->second = free_cables(a, pose);
            for (const FreeCable& cable : cables->second) {
                if (cable.side != Side::kAgonist || touches(cable, body)) continue;
                Gap& gap = of_body.try_emplace(cable.kind, Gap{name_of(cable), body.name, kNear_mm, 0.0, pose}).first->second;
                if (apart_mm(cable, around.middle_at(at)) - around.radius_mm >= gap.mm + 0.5 * a.cable_mm) continue;
                double mm = gap.mm + 0.5 * a.cable_mm;
                if (prisms.empty()) prisms = placed_all(body, at);
                for (const Prism& prism : prisms) mm = distance_mm(cable.from_mm, cable.to_mm, prism, mm);
                if (mm - 0.5 * a.cable_mm < gap.mm) gap.mm = std::max(mm - 0.5 * a.cable_mm, 0.0), gap.pose = pose;
            }
        });
        for (auto& [kind, gap] : of_body) gaps.push_back(std::move(gap));
    }
    sort(gaps);
    return gaps;
}

}  // namespace fusee::assembly
