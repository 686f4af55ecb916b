#pragma once
#include <map>
#include <string>
#include <string_view>

namespace fusee::toolpath::mill {

using Parameters = std::map<std::string, double>;

/// Takes one value from the front of `text`: a number, #<name> or an expression in brackets. @returns false if there is none
bool take_value(std::string_view& text, const Parameters& parameters, double& value);

}  // namespace fusee::toolpath::mill
