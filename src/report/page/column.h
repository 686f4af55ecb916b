#pragma once
#include "fusee/core/lists.h"

namespace fusee::report {

/// One value of every row, for a curve. @param of a function or a pointer to a member
template <class Row, class Of>
[[nodiscard]] std::vector<double> column(const std::vector<Row>& rows, const Of& of) {
    return core::each<double>(rows, of);
}

}  // namespace fusee::report
