#pragma once
#include <functional>
#include <vector>

namespace fusee::report {

/// One value of every row, for a curve. @param of a function or a pointer to a member
template <class Row, class Of>
[[nodiscard]] std::vector<double> column(const std::vector<Row>& rows, const Of& of) {
    std::vector<double> values;
    values.reserve(rows.size());
    for (const Row& row : rows) values.push_back(std::invoke(of, row));
    return values;
}

}  // namespace fusee::report
