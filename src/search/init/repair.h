#pragma once
#include <optional>

#include "fusee/search/init.h"

namespace fusee::search::init {

/// The nearest law of each measured spring for which the conditions of `broken_at_once` hold: the measured springs go on in a straight line
/// to the angles that the answers ask, and a polynomial of degree 5 is added to a spring whose contour breaks a limit, such that the root
/// mean square of the change over the angle is least. Found by differential evolution over polynomial, size, preload and capstan; the same
/// on any number of threads.
/// @pre answers.law @returns none if no such law was found @throws core::Stopped
[[nodiscard]] std::optional<Repair> find_repair(const Answers& answers, const InitOptions& options);

}  // namespace fusee::search::init
