// What tests/bench/cost.py measures every command against: floating point, scattered memory and small allocations, about 0.5 s. Never
// change it.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

int main() {
    std::vector<double> table(1U << 19);
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = std::sin(1e-3 * static_cast<double>(i));
    std::vector<std::unique_ptr<std::vector<double>>> kept(4096);
    std::uint64_t random = 1;
    double sum = 0.0;
    for (int i = 0; i < 6'000'000; ++i) {
        random = random * 6364136223846793005U + 1442695040888963407U;
        const double x = table[random >> 45U];
        sum = 0.5 * sum + x * x - std::exp(-std::abs(x));
        if (i % 4 == 0) kept[random >> 52U] = std::make_unique<std::vector<double>>(1 + (random >> 40U) % 32, sum);
    }
    std::printf("%g\n", sum);
}
