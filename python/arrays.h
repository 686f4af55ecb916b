#pragma once
#include <array>
#include <memory>
#include <vector>

#include "bindings.h"

/// Arrays that show the memory of a C++ object and keep it alive; nobody can write to them.
namespace fusee::python {

using Owner = std::shared_ptr<const void>;

/// @param first where the array begins; null: it is empty
template <class Value>
[[nodiscard]] py::array_t<Value> view(const Owner& owner, const Value* first, const std::vector<py::ssize_t>& shape,
                                      const std::vector<py::ssize_t>& strides) {
    const py::capsule base(new Owner(owner), [](void* kept) { delete static_cast<Owner*>(kept); });
    py::array_t<Value> array = first == nullptr ? py::array_t<Value>(shape) : py::array_t<Value>(shape, strides, first, base);
    array.attr("flags").attr("writeable") = false;
    return array;
}

/// One member of each row, "[](const Row& row) -> const double& { return row.tau; }".
template <class Row, class Get>
[[nodiscard]] auto column(const Owner& owner, const std::vector<Row>& rows, const Get& get) {
    using Value = std::remove_cvref_t<std::invoke_result_t<Get, const Row&>>;
    static_assert(std::is_lvalue_reference_v<std::invoke_result_t<Get, const Row&>>, "a copy would be gone at once");
    return view<Value>(owner, rows.empty() ? nullptr : &get(rows.front()), {static_cast<py::ssize_t>(rows.size())}, {sizeof(Row)});
}

/// Rows of N numbers each: the points or triangles of a mesh.
template <class Value, std::size_t N>
[[nodiscard]] py::array_t<Value> table(const Owner& owner, const std::vector<std::array<Value, N>>& rows) {
    return view<Value>(owner, rows.empty() ? nullptr : rows.front().data(), {static_cast<py::ssize_t>(rows.size()), N},
                       {sizeof(std::array<Value, N>), sizeof(Value)});
}

/// All numbers of a vector.
template <class Value>
[[nodiscard]] py::array_t<Value> numbers(const Owner& owner, const std::vector<Value>& values) {
    return column(owner, values, [](const Value& value) -> const Value& { return value; });
}

/// The caller's numbers: anything that NumPy turns into an array of one dimension.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
[[nodiscard]] inline std::vector<double> vector_of(const Numbers& array) { return {array.data(), array.data() + array.size()}; }

/// `compute` of each number, in an array of the same shape.
template <class Compute>
[[nodiscard]] py::array_t<double> each(const Numbers& x, const Compute& compute) {
    py::array_t<double> y(std::vector<py::ssize_t>(x.shape(), x.shape() + x.ndim()));
    for (py::ssize_t i = 0; i < x.size(); ++i) y.mutable_data()[i] = compute(x.data()[i]);
    return y;
}

}  // namespace fusee::python
