#pragma once
#include <fmt/format.h>

#include <iterator>
#include <string>
#include <type_traits>

namespace fusee::report {

/// A row of a CSV file; floating-point numbers have 17 digits, so that they are read back bit for bit.
template <class... Values>
void add_csv_row(std::string& csv, const Values&... values) {
    const char* separator = "";
    const auto add = [&](const auto& value) {
        csv += separator;
        separator = ",";
        if constexpr (std::is_floating_point_v<std::decay_t<decltype(value)>>)
            fmt::format_to(std::back_inserter(csv), "{:.17g}", value);
        else
            fmt::format_to(std::back_inserter(csv), "{}", value);
    };
    (add(values), ...);
    csv += '\n';
}

}  // namespace fusee::report
