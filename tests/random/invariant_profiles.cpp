// invariant_profiles COUNT SEED [FIRST [files] [random]]: tries the invariants on COUNT designs near the shipped ones, or random ones (helices,
// idlers, other laws), "files" also the fixed point through an STL, and prints how many designs each was tried on, its largest error and those that broke it. Exit code 1 if one did.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>

#include "fusee/core/progress.h"
#include "generator.h"
#include "invariants.h"

using namespace fusee;
using namespace fusee::random_profiles;

int main(int argc, char** argv) {
    if (argc < 3 || argc > 6) {
        fmt::print(stderr, "usage: invariant_profiles COUNT SEED [FIRST [files] [random]]\n");
        return 2;
    }
    const int first = argc > 3 ? std::atoi(argv[3]) : 0, count = std::atoi(argv[1]);
    const auto seed = static_cast<std::uint64_t>(std::atoll(argv[2]));
    const std::set<std::string> words(argv + std::min(argc, 4), argv + argc);
    const bool files = words.contains("files"), random = words.contains("random");
    core::catch_interrupts();
    std::array<int, kInvariants> tried{}, broken{};
    std::array<double, kInvariants> worst{};
    int number = first;
    for (; number < first + count && !core::interrupted(); ++number) {
        const Shown shown = try_invariants(random ? random_profile(seed, number) : near_profile(seed, number), seed, number, files);
        for (std::size_t i = 0; i < kInvariants; ++i) {
            if (!shown.error[i]) continue;
            ++tried[i];
            const double error = *shown.error[i];
            if (error > worst[i]) worst[i] = error;
            if (error <= kAllowed[i]) continue;  // NaN is broken
            ++broken[i];
            fmt::print("{:05}: {}: {:.3g} (allowed {:.3g})\n", number, kInvariantNames[i], error, kAllowed[i]);
        }
    }
    fmt::print("designs {} to {} of seed {}\n\n| invariant | designs | largest error | allowed | broken |\n|---|---|---|---|---|\n", first,
               number - 1, seed);
    int all = 0;
    for (std::size_t i = 0; i < kInvariants; ++i) {
        fmt::print("| {} | {} | {:.2g} | {:.2g} | {} |\n", kInvariantNames[i], tried[i], worst[i], kAllowed[i], broken[i]);
        all += broken[i];
    }
    return all > 0 ? 1 : 0;
}
