#pragma once
#include <memory>
#include <mutex>

#include "bindings.h"
#include "fusee/simulator/model.h"
#include "work.h"

namespace fusee::python {

/// A case whose simulator is a function of the caller.
struct OwnModel {
    std::shared_ptr<const simulator::Case> value;  ///< never null
    py::object simulate;
};
/// Calls the function, one call at a time, with the interpreter's lock. What it raises stops the work, but for fusee.Refusal.
/// @pre model and watch outlive the result
[[nodiscard]] simulator::Simulate simulate_by(const OwnModel& model, Watch& watch);

}  // namespace fusee::python
