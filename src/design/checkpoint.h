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

/// @param finished nothing is lost when another search takes its place @throws core::IoError
void write_checkpoint(const EvolutionOptions& options, const Generation& state, bool finished);

/// May a search that begins anew take the checkpoint's place? @throws core::IoError if it cannot be written, if it is no checkpoint, or if
/// it holds a search that was stopped and options.force is not set
void require_replaceable(const EvolutionOptions& options);

/// Nothing if there is no such file.
/// @throws core::InvalidInput naming what is another one in the checkpoint; core::IoError if it is damaged
[[nodiscard]] std::optional<Generation> read_checkpoint(const EvolutionOptions& options);

}  // namespace fusee::design
