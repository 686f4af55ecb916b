#pragma once
#include <memory>
#include <span>
#include <vector>

#include "fusee/design/evolution.h"

namespace fusee::design {

/// A cost as a pagmo problem whose arguments are evaluated many at a time. pagmo's headers stay in batch.cpp.
class Batch {
public:
    /// @param jobs threads; 0 = one for each processor
    Batch(Cost cost, const std::vector<core::Range>& bounds, unsigned jobs);
    ~Batch();
    Batch(const Batch&) = delete;
    Batch& operator=(const Batch&) = delete;

    /// The costs of the arguments that stand one after the other in `rows`, in their order; what is not finite becomes the largest double.
    [[nodiscard]] std::vector<double> operator()(const std::vector<double>& rows) const;

private:
    struct Machine;
    std::unique_ptr<Machine> machine_;
};

}  // namespace fusee::design
