#pragma once
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "gaps.h"

namespace fusee::assembly {

/// Proves a distance of two bodies over every pose of the working range, not only at samples. The range is cut into boxes; in each, a body
/// that slides is taken as the hull of all its places, one that turns as the disc around it, or, where it turns by little, in its middle
/// pose with its distance less the way of its farthest point. Boxes whose bound is below the aim are halved. `gap` holds the sampled least
/// distance on entry; its distance and pose are lowered where a middle pose is nearer, and `proven_mm` is set.
/// @param enough_mm proofs beyond it are not sought
void prove(const Assembly& assembly, const Body& one, const Body& other, double enough_mm, Gap& gap);

/// What holds a body in every pose of a box, once each prism is wider by `loss_mm`.
struct Enclosure {
    std::vector<Prism> prisms;
    double loss_mm = 0.0;
};

/// Bounds of pairs over the whole range as one box. What holds a body there is found once for all its partners.
class WholeRange {
public:
    explicit WholeRange(const Assembly& assembly) : a_(assembly) {}
    /// `most_mm` if it is that much or more
    [[nodiscard]] double bound_mm(const Body& one, const Body& other, double most_mm);

private:
    const Assembly& a_;
    std::map<std::pair<const Body*, std::array<double, 4>>, Enclosure> known_;  ///< by the ends of the ranges that move the body
};

}  // namespace fusee::assembly
