#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "fusee/core/progress.h"
#include "fusee/core/units.h"

namespace fusee::design {

/// A cost to be minimised over a box. Called from several threads; equal arguments give equal values; an infinite or NaN cost counts as the
/// worst.
using Cost = std::function<double(std::span<const double>)>;

struct EvolutionOptions {
    std::vector<core::Range> bounds;
    int population = 40;  ///< >= 8
    int generations = 200;
    double weight = 0.7;     ///< F of DE/rand-to-best/1/bin, dithered by +-20 % (Storn & Price 1997), above 0, at most 2
    double crossover = 0.9;  ///< 0 to 1
    double tolerance = 0.0;  ///< ends when the population's costs lie within this (absolute); 0: all generations
    std::uint64_t seed = 1;
    unsigned jobs = 0;                      ///< threads; 0 = one for each processor; no influence on the result
    std::filesystem::path checkpoint = {};  ///< written after every `checkpoint_every` generations and at the end; empty: none
    int checkpoint_every = 10;
    bool resume = false;       ///< continue from the checkpoint if it exists; refused if its problem, box, seed or population differs
    bool force = false;        ///< replace the checkpoint of a stopped search
    std::string problem = "";  ///< identifies the cost in the checkpoint
    std::function<void(int generation, double best)> progress = {};          ///< after each generation, on the caller's thread
    std::function<void(std::span<const double>, double cost)> observe = {};  ///< every evaluation, in order, on the caller's thread
    std::function<bool()> stop = core::interrupted;                          ///< asked before each generation
};

struct EvolutionResult {
    std::vector<double> best;
    double cost = 0.0;
    std::size_t evaluations = 0;
    int generations = 0;          ///< done
    bool interrupted = false;     ///< ended by `stop`: the best so far
    std::vector<double> history;  ///< best cost of the first population and after each generation: generations + 1 values
};

/// Differential Evolution (Storn & Price 1997) by generations: every trial vector of a generation is drawn from the counter-based stream
/// of (seed, generation, individual), so that any number of threads, and any stop and resume, gives the same bits
/// (docs/decisions/0005-de-by-generations.md).
/// @throws InvalidInput naming the option, or the difference to the checkpoint; IoError if the checkpoint cannot be read or written, if the
/// file is not a checkpoint, or if it holds a stopped search and neither `resume` nor `force` is set
[[nodiscard]] EvolutionResult evolve(const Cost& cost, const EvolutionOptions& options);

}  // namespace fusee::design
