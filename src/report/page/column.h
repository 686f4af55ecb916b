#pragma once
#include <vector>

namespace fusee::report {

/// One figure of every row, for a curve.
template <class Row, class Of>
[[nodiscard]] std::vector<double> column(const std::vector<Row>& rows, const Of& of) {
    std::vector<double> values;
    values.reserve(rows.size());
    for (const Row& row : rows) values.push_back(of(row));
    return values;
}

}  // namespace fusee::report
