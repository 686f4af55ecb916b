#pragma once
#include <optional>
#include <vector>

#include "fusee/design/evolution.h"

namespace fusee::design {

/// A population after some generations: with the options, all that the next generation depends on.
struct Generation {
    int number = 0;               ///< generations done; 0: the first population
    std::vector<double> members;  ///< one after the other
    std::vector<double> costs;
    std::size_t evaluations = 0;
    std::vector<double> history;
};

/// @param finished the search is complete and may be replaced by another @throws core::IoError
void write_checkpoint(const EvolutionOptions& options, const Generation& state, bool finished);

/// Checks that a new search may replace the checkpoint. @throws core::IoError if it cannot be written, if the file is not a checkpoint, or
/// if it holds a stopped search and options.force is not set
void require_replaceable(const EvolutionOptions& options);

/// Nothing if there is no such file.
/// @throws core::InvalidInput naming the option that differs in the checkpoint; core::IoError if it is damaged
[[nodiscard]] std::optional<Generation> read_checkpoint(const EvolutionOptions& options);

}  // namespace fusee::design
