#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "fusee/core/units.h"

namespace fusee::search {

/// One searched number of a design: its box as it is searched, and what it changes in a draft of the design.
template <class Draft>
struct Variable {
    std::string name, unit;
    core::Range bounds;
    std::function<void(Draft&, double)> set;
    double (*shown)(double) = [](double x) { return x; };  ///< as a person reads it: a number that is searched by its logarithm, itself
};

template <class Draft>
[[nodiscard]] std::vector<core::Range> bounds_of(const std::vector<Variable<Draft>>& variables) {
    std::vector<core::Range> bounds;
    for (const Variable<Draft>& variable : variables) bounds.push_back(variable.bounds);
    return bounds;
}

/// The draft with every number entered, in the order of the variables. @pre as many numbers as variables
template <class Draft>
[[nodiscard]] Draft entered(Draft draft, const std::vector<Variable<Draft>>& variables, std::span<const double> x) {
    for (std::size_t i = 0; i < variables.size(); ++i) variables[i].set(draft, x[i]);
    return draft;
}

}  // namespace fusee::search
