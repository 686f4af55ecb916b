#pragma once
#include "fusee/design/algorithm_1.h"

namespace fusee::design {

/// Search methods of `fusee design`.
enum class Method {
    kAlgorithm1,  ///< the paper's (k, u, C) by its Algorithm 1, springs alone
    kCoDesign,    ///< a law together with base springs, radius and lead-in, inside what can be made
    kPareto,      ///< the same for two objectives: a front of designs
};

/// Settings of every method.
struct SearchOptions {
    Method method = Method::kAlgorithm1;
    int population = 60;    ///< >= 8; of a Pareto front, a multiple of 4
    int generations = 300;  ///< >= 1
    int seed = 1;           ///< >= 0: the same seed gives the same result, bit for bit, on any number of threads
};

}  // namespace fusee::design
