#pragma once
#include <cstdint>
#include <numeric>
#include <vector>

namespace fusee::core {

/// Numbers that are joined into sets; its least member names a set, in any order of joining.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count = 0) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
    /// A further number, in a set of its own.
    std::uint32_t add() { return parent_.emplace_back(static_cast<std::uint32_t>(parent_.size())); }
    [[nodiscard]] std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a), b = find(b);
        parent_[a < b ? b : a] = a < b ? a : b;
    }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace fusee::core
