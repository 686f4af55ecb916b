#pragma once
#include <functional>
#include <stdexcept>

namespace fusee::brep {

/// What OpenCASCADE threw, in its own words: its Standard_Failure is no std::exception.
class Failure : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Does `work`, which calls OpenCASCADE. @throws Failure in the place of a Standard_Failure; std::bad_alloc where memory ran out
void guard(const std::function<void()>& work);

}  // namespace fusee::brep
