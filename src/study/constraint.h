#pragma once
#include <functional>
#include <string>
#include <vector>

#include "fusee/study/study.h"

namespace fusee::study {

/// The names of keys in a formula. @throws core::InvalidInput naming `field` if it is no formula
[[nodiscard]] std::vector<std::string> keys_in(const std::string& field, const std::string& formula);

/// The formula's value. @param number the value of a key that it names
/// @throws core::InvalidInput naming `field` if it cannot be evaluated or is not finite
[[nodiscard]] double evaluate(const std::string& field, const std::string& formula,
                              const std::function<double(const std::string&)>& number);

}  // namespace fusee::study
