#pragma once
#include <array>

#include "fusee/design/algorithm_1.h"

namespace fusee::design {

/// Search methods of `fusee design`.
enum class Method {
    kAlgorithm1,  ///< the paper's (k, u, C) by its Algorithm 1, springs alone
    kCoDesign,    ///< a law together with base springs, radius and lead-in, inside what can be made
    kPareto,      ///< the same for two objectives: a front of designs
};

/// Their names in profiles and on the command line, in the order of the enumeration.
inline constexpr std::array kMethodNames{"algorithm_1", "co_design", "pareto"};

/// Settings of every method.
struct SearchOptions {
    Method method = Method::kAlgorithm1;
    int population = 60;    ///< >= 8; of a Pareto front, a multiple of 4
    int generations = 300;  ///< >= 1
    int seed = 1;           ///< >= 0: the same seed gives the same result, bit for bit, on any number of threads
};

}  // namespace fusee::design
