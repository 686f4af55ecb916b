#pragma once
#include <array>
#include <functional>
#include <span>
#include <vector>

#include "fusee/core/units.h"

namespace fusee::search::codesign {

/// Two costs of one argument, both to be minimised. Called from several threads.
using Costs = std::function<std::array<double, 2>(std::span<const double>)>;

struct FrontOptions {
    std::vector<core::Range> bounds;
    int population = 60;  ///< a multiple of 4, >= 8
    int generations = 300;
    unsigned seed = 1;
    unsigned jobs = 0;                                               ///< threads; 0 = one for each processor; no influence on the result
    std::vector<std::vector<double>> seeds = {};                     ///< good members of the first population
    std::function<void(int generation, double best)> progress = {};  ///< the least first cost
    std::function<bool()> stop = {};                                 ///< asked before each part of the generations
};

struct Front {
    std::vector<std::vector<double>> members;  ///< none dominated by another nor equal to it, by rising first cost
    std::size_t evaluations = 0;
    int generations = 0;  ///< completed
    bool interrupted = false;
};

/// NSGA-II (Deb et al. 2002) of pagmo, evaluated a generation at a time; the same bits on any number of threads.
/// @throws InvalidInput naming the option
[[nodiscard]] Front find_front(const Costs& costs, const FrontOptions& options);

}  // namespace fusee::search::codesign

/// The one function of the module fusee_nsga2.so, which find_front loads. Searches numbers that all have a range, with the threads of the
/// caller. @param front set to the result
extern "C" [[gnu::visibility("default")]] void fusee_nsga2(const fusee::search::codesign::Costs& costs,
                                                           const fusee::search::codesign::FrontOptions& options,
                                                           fusee::search::codesign::Front& front);
