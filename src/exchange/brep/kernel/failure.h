#pragma once
#include <functional>
#include <stdexcept>

namespace fusee::exchange::brep {

/// An exception of OpenCASCADE with its text: its Standard_Failure is not a std::exception.
class Failure : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Runs `work`, which calls OpenCASCADE. @throws Failure in place of a Standard_Failure; std::bad_alloc if memory is exhausted
void guard(const std::function<void()>& work);

}  // namespace fusee::exchange::brep
