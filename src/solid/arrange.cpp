#include "fusee/solid/arrange.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <numeric>

namespace fusee::solid {

namespace {

constexpr double kRounding_mm = 1e-9;  // a bed that fits exactly fits

struct Placed {
    Size2 corner, size;
};

bool apart(const Placed& a, const Placed& b, double spacing) {
    for (std::size_t i = 0; i < 2; ++i)
        if (a.corner[i] + a.size[i] + spacing <= b.corner[i] + kRounding_mm ||
            b.corner[i] + b.size[i] + spacing <= a.corner[i] + kRounding_mm)
            return true;
    return false;
}

/// The lowest, then leftmost place: its sides lie on the bed's or at a spacing from placed rectangles.
std::optional<Size2> place(const std::vector<Placed>& placed, Size2 size, Size2 bed, double spacing) {
    std::vector<double> xs{0.0}, ys{0.0};
    for (const Placed& s : placed) xs.push_back(s.corner[0] + s.size[0] + spacing), ys.push_back(s.corner[1] + s.size[1] + spacing);
    std::sort(xs.begin(), xs.end());
    std::sort(ys.begin(), ys.end());
    for (const double y : ys)
        for (const double x : xs) {
            if (x + size[0] > bed[0] + kRounding_mm || y + size[1] > bed[1] + kRounding_mm) continue;
            const Placed here{{x, y}, size};
            if (std::all_of(placed.begin(), placed.end(), [&](const Placed& s) { return apart(here, s, spacing); })) return here.corner;
        }
    return std::nullopt;
}

/// @param turns bit i: rectangle i is turned
std::optional<std::vector<Spot>> arrange_in_order(const std::vector<Size2>& sizes, const std::vector<std::size_t>& order, unsigned turns,
                                                  Size2 bed, double spacing) {
    std::vector<Placed> placed;
    std::vector<Spot> spots(sizes.size());
    for (const std::size_t i : order) {
        const bool turned = (turns >> i & 1U) != 0;
        const Size2 size = turned ? Size2{sizes[i][1], sizes[i][0]} : sizes[i];
        const auto corner = place(placed, size, bed, spacing);
        if (!corner) return std::nullopt;
        placed.push_back({*corner, size});
        spots[i] = {turned, *corner};
    }
    return spots;
}

}  // namespace

std::optional<std::vector<Spot>> arrange(const std::vector<Size2>& sizes_mm, Size2 bed_mm, double spacing_mm) {
    assert(sizes_mm.size() <= 6 && "every order is evaluated");
    std::vector<unsigned> turns(1U << sizes_mm.size());
    std::iota(turns.begin(), turns.end(), 0U);
    std::stable_sort(turns.begin(), turns.end(), [](unsigned a, unsigned b) { return std::popcount(a) < std::popcount(b); });
    for (const unsigned turned : turns) {
        std::vector<std::size_t> order(sizes_mm.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        do {
            if (auto spots = arrange_in_order(sizes_mm, order, turned, bed_mm, spacing_mm)) return spots;
        } while (std::next_permutation(order.begin(), order.end()));
    }
    return std::nullopt;
}

double least_bed(const std::vector<Size2>& sizes_mm, Size2 bed_mm, double spacing_mm) {
    constexpr double kAccuracy = 1e-3;
    const auto fits = [&](double factor) { return arrange(sizes_mm, {factor * bed_mm[0], factor * bed_mm[1]}, spacing_mm).has_value(); };
    double low = 0.0, high = 1.0;
    while (!fits(high)) low = high, high *= 2.0;
    while (high - low > kAccuracy * high) (fits(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
    return high;
}

}  // namespace fusee::solid
