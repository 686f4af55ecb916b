#pragma once
#include <optional>
#include <vector>

#include "fusee/design/evolution.h"

namespace fusee::design {

/// A population after some generations: all that the next generation depends on besides the options.
struct Generation {
    int number = 0;               ///< generations done; 0: the first population
    std::vector<double> members;  ///< one after the other
    std::vector<double> costs;
    std::size_t evaluations = 0;
    std::vector<double> history;
};

/// @throws core::IoError
void write_checkpoint(const EvolutionOptions& options, const Generation& state);

/// Nothing if there is no such file.
/// @throws core::InvalidInput naming what is another one in the checkpoint; core::IoError if it is damaged
[[nodiscard]] std::optional<Generation> read_checkpoint(const EvolutionOptions& options);

}  // namespace fusee::design
