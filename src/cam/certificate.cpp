#include "fusee/cam/certificate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <queue>

#include "fusee/core/error.h"

namespace fusee::cam {

namespace {

using math::Interval;
using math::Jet;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kWiderInSpace = 10.0;  // gap: d2rho/dpsi2 is unknown, so the bounds converge only as fast as the boxes shrink

/// NaN as a bound means no bound.
double lower(const Interval& x) { return std::isnan(x.lower()) ? -kInfinity : x.lower(); }
double upper(const Interval& x) { return std::isnan(x.upper()) ? kInfinity : x.upper(); }

/// A radius whose least value is searched; an unknown slope is the whole line.
using Radius = std::function<Jet(const ContourJet&)>;

/// eq. 14 for the curve `depth` inside the centreline.
Jet radius_in_space(const ContourJet& at, double depth) {
    using boost::numeric::sqrt, boost::numeric::square;
    const Interval rho = at.rho.value - depth, rise = at.rho.slope / at.psi.slope;  // d rho/d psi: the same on every parallel curve
    const Interval tangent = at.axial_slope / rho, turn = 1.0 + square(tangent);
    const Interval twist = (at.axial_slope_rate - tangent * rise) / rho;
    return {rho * turn * sqrt(turn) / sqrt(turn + square(twist)), math::whole_line()};
}

/// A box of a piece with its bounds.
struct Box {
    const ContourPiece* piece;
    Interval parameter;
    double lower;
    int number;  ///< breaks ties, so that the order of the search is unique
    [[nodiscard]] bool operator<(const Box& other) const {
        return lower != other.lower ? lower > other.lower : number > other.number;  // std::priority_queue's top is the greatest
    }
};

/// One search's budget.
class Budget {
public:
    Budget(int most, int& total) : left_(most), total_(total) {}
    [[nodiscard]] bool spent() const { return left_ <= 0; }
    int take() {
        --left_;
        return ++total_;
    }

private:
    int left_;
    int& total_;
};

bool divisible(const Interval& x) {
    const double middle = math::middle(x);
    return x.lower() < middle && middle < x.upper();
}

/// Branch and bound: the box with the lowest bound is halved until the bound is within the gap of a known radius.
class LeastSearch {
public:
    LeastSearch(const Radius& radius, double gap, Budget budget) : radius_(radius), gap_(gap), budget_(budget) {}

    [[nodiscard]] LeastRadius over(const std::vector<const ContourPiece*>& pieces) {
        for (const ContourPiece* s : pieces) add(*s, {s->parameter.low, s->parameter.high});
        while (!queue_.empty()) {
            const Box top = queue_.top();
            const bool good = found_ - top.lower <= gap_ * std::abs(found_);
            if (good || budget_.spent() || !divisible(top.parameter))
                return {top.lower, found_, math::range_of(top.piece->over(top.parameter).psi.value)};
            queue_.pop();
            const double middle = math::middle(top.parameter);
            add(*top.piece, {top.parameter.lower(), middle});
            add(*top.piece, {middle, top.parameter.upper()});
        }
        return {-kInfinity, kInfinity, {}};
    }

private:
    /// The formula over the box, and its mean-value form about the middle: each encloses the values, so their intersection does too.
    void add(const ContourPiece& piece, const Interval& parameter) {
        const double middle = math::middle(parameter);
        const Jet radius = radius_(piece.over(parameter));
        const Interval here = radius_(piece.over(Interval(middle))).value;
        const Interval bounds = math::common(radius.value, here + radius.slope * (parameter - middle));
        found_ = std::min(found_, upper(here));
        queue_.push({&piece, parameter, lower(bounds), budget_.take()});
    }

    const Radius& radius_;
    double gap_;
    Budget budget_;
    std::priority_queue<Box> queue_;
    double found_ = kInfinity;
};

/// Is psi strictly monotone as the cam turns? Undecided boxes are halved.
struct OrderProof {
    Proof proof = Proof::kProven;
    core::Range psi;  ///< the last undecided or failing box
};
OrderProof prove_order(const std::vector<const ContourPiece*>& pieces, const CertifyOptions& options, int& boxes) {
    Budget budget(options.most_boxes, boxes);
    std::optional<bool> rising;
    for (const ContourPiece* s : pieces) {
        std::deque<Interval> open{{s->parameter.low, s->parameter.high}};  // in turn, so that a failing place is found early
        while (!open.empty()) {
            const Interval box = open.front();
            open.pop_front();
            budget.take();
            const ContourJet at = s->over(box);
            const Interval turn = at.psi.slope / at.angle.slope;
            if (!rising && (lower(turn) > 0.0 || upper(turn) < 0.0)) rising = lower(turn) > 0.0;
            const bool runs = rising.value_or(true) ? lower(turn) > 0.0 : upper(turn) < 0.0;
            if (runs && lower(at.angle.slope) > 0.0) continue;
            const bool fails = upper(at.angle.slope) <= 0.0 || (rising && (*rising ? upper(turn) <= 0.0 : lower(turn) >= 0.0));
            if (fails) return {Proof::kRefuted, math::range_of(at.psi.value)};
            if (budget.spent() || !divisible(box)) return {Proof::kNotProven, math::range_of(at.psi.value)};
            const double middle = math::middle(box);
            open.emplace_back(box.lower(), middle);
            open.emplace_back(middle, box.upper());
        }
    }
    return {};
}

/// One failing place refutes the claim, for any bounds elsewhere.
Proof judge(const Certificate& c) {
    const double found = std::min(c.working.found, c.idle ? c.idle->found : kInfinity);
    return c.least().proven > 0.0 ? Proof::kProven : found <= 0.0 ? Proof::kRefuted : Proof::kNotProven;
}

std::string place(const core::Range& psi) { return fmt::format("psi {:.6g} to {:.6g} rad", psi.low, psi.high); }

/// Remarks for every claim that is not "proven".
std::string remarks(const Certificate& c, const OrderProof& order, double gap) {
    std::string text;
    const auto say = [&](const std::string& line) { text += (text.empty() ? "" : "; ") + line; };
    if (c.convex != Proof::kProven) say(fmt::format("convexity is {} at {}", to_string(c.convex), place(c.least().psi)));
    if (order.proof != Proof::kProven) say(fmt::format("the cable's order is {} at {}", to_string(order.proof), place(order.psi)));
    const auto judge_gap = [&](const char* what, const std::optional<LeastRadius>& r, double allowed) {
        if (r && !(r->found - r->proven <= allowed * std::abs(r->found)))
            say(fmt::format("the search for the least radius of {} stopped at {}", what, place(r->psi)));
    };
    judge_gap("the working arc", c.working, gap);
    judge_gap("the idle arc or run-outs", c.idle, gap);
    judge_gap("the floor in space", c.floor, kWiderInSpace * gap);
    judge_gap("the floor in space of the run-outs", c.idle_floor, kWiderInSpace * gap);
    return text;
}

}  // namespace

const char* to_string(Proof proof) { return proof == Proof::kProven ? "proven" : proof == Proof::kRefuted ? "refuted" : "not proven"; }

const LeastRadius& Certificate::least() const { return idle && idle->proven < working.proven ? *idle : working; }

std::optional<core::Finding> doubt(const Certificate& certificate, PartKind kind) {
    const bool refuted = certificate.convex == Proof::kRefuted || certificate.ordered == Proof::kRefuted;
    if (!refuted && certificate.convex == Proof::kProven && certificate.ordered == Proof::kProven) return std::nullopt;
    const LeastRadius& least = certificate.least();
    core::Finding f = core::error_finding("cam.certificate", "proof that the contour is convex and the cable unrolls in order",
                                          core::mm_from_m(refuted ? least.found : least.proven), core::Bound::kAtLeast, 0.0, "mm");
    f.severity = refuted ? core::Severity::kError : core::Severity::kWarning;
    f.where = fmt::format("{}: {}", to_string(kind), certificate.open);
    f.suggestion = refuted ? "another base spring or law: see cam.convexity" : "a law of formulas, tables or knots, which have bounds";
    f.source = "docs/theory/cams.md, certificate: interval arithmetic";
    return f;
}

const std::vector<std::string>& certificate_assumptions() {
    static const std::vector<std::string> kAll = {
        "the constants of law, springs and guide are the doubles of the geometry",
        "the C library's exp, expm1, log1p, cos and acos have errors of at most 4 ulp (the library promises 1)",
        "the geometry itself evaluates the same formulas in double precision; its rounding is not part of the proof",
    };
    return kAll;
}

Certificate certify(const std::vector<ContourPiece>& contour, bool helix, const CertifyOptions& options) {
    core::require_positive("certify.gap", options.gap);
    core::require_within("certify.most_boxes", options.most_boxes, 1, 100000000);
    std::vector<const ContourPiece*> working, idle;
    for (const ContourPiece& s : contour) (s.working ? working : idle).push_back(&s);
    Certificate c;
    const double depth = options.floor_depth;
    const Radius plane = [](const ContourJet& at) { return at.rho; };
    const Radius floor = [depth](const ContourJet& at) { return radius_in_space(at, depth); };
    const auto in_plane = [&](const std::vector<const ContourPiece*>& pieces) {
        return LeastSearch(plane, options.gap, {options.most_boxes, c.boxes}).over(pieces);
    };
    const auto in_space = [&](const std::vector<const ContourPiece*>& pieces, const LeastRadius& flat) -> std::optional<LeastRadius> {
        if (!helix || !(flat.proven > depth)) return std::nullopt;  // a floor with a cusp has no least radius
        return LeastSearch(floor, kWiderInSpace * options.gap, {options.most_boxes, c.boxes}).over(pieces);
    };
    c.working = in_plane(working);
    c.floor = in_space(working, c.working);
    if (!idle.empty()) {
        c.idle = in_plane(idle);
        c.idle_floor = in_space(idle, *c.idle);
    }
    c.convex = judge(c);
    const OrderProof order = working.empty() ? OrderProof{Proof::kNotProven, {}} : prove_order(working, options, c.boxes);
    c.ordered = order.proof;
    c.open = working.empty() ? "the law has no bounds over a range, only values at points" : remarks(c, order, options.gap);
    return c;
}

Certificate certify(const Cam& cam, const CertifyOptions& options) {
    CertifyOptions floor = options;
    floor.floor_depth = 0.5 * cam.options.cable_diameter;
    Certificate c = certify(cam.pieces ? cam.pieces() : std::vector<ContourPiece>{}, !cam.closed(), floor);
    c.seam = seam(cam);
    return c;
}

double seam(const Cam& cam) {
    if (!cam.closed() || !cam.path) return 0.0;
    constexpr double kBefore = 1e-7;  // before the turn's end: the idle arc, extrapolated from there by its derivatives
    const double begin = cam.working_psi.low;
    const PathPoint first = cam.path(begin), last = cam.path(begin + 2.0 * core::kPi - kBefore);
    return std::max(std::abs(first.h - (last.h + kBefore * last.slope)),
                    std::abs(first.slope - (last.slope + kBefore * (last.rho - last.h))));
}

}  // namespace fusee::cam
