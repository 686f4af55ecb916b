#include "front.h"

#include <fmt/format.h>

#include "fusee/core/error.h"
#include "fusee/core/lists.h"
#include "fusee/core/module.h"
#include "fusee/core/parallel.h"

namespace fusee::search::codesign {

namespace {

void validate(const FrontOptions& o) {
    if (o.population < 8 || o.population % 4 != 0)
        throw core::InvalidInput("design.population", fmt::format("{}", o.population), "a multiple of 4, at least 8, for a Pareto front");
    core::require_within("design.generations", o.generations, 1, 1'000'000);
}

/// NSGA-II crosses and mutates only numbers that have a range.
class Free {
public:
    explicit Free(const std::vector<core::Range>& bounds) : bounds_(bounds) {
        for (std::size_t i = 0; i < bounds.size(); ++i)
            if (bounds[i].low < bounds[i].high) free_.push_back(i);
    }
    [[nodiscard]] bool all() const { return free_.size() == bounds_.size(); }
    [[nodiscard]] bool none() const { return free_.empty(); }

    /// The numbers that have a range.
    template <class Value>
    [[nodiscard]] std::vector<Value> of(const std::vector<Value>& values) const {
        return core::each<Value>(free_, [&](const std::size_t i) { return values[i]; });
    }
    /// All of them, the others at their only value.
    [[nodiscard]] std::vector<double> with_fixed(std::span<const double> some) const {
        auto values = core::each<double>(bounds_, &core::Range::low);
        for (std::size_t i = 0; i < free_.size(); ++i) values[free_[i]] = some[i];
        return values;
    }

private:
    const std::vector<core::Range>& bounds_;
    std::vector<std::size_t> free_;
};

Front search(const Costs& costs, const FrontOptions& options) {
    // pagmo takes 70 ms to start: it is loaded when a front is searched.
    static const auto nsga2 = reinterpret_cast<decltype(&fusee_nsga2)>(core::loaded_function("fusee_nsga2.so", "fusee_nsga2"));
    Front front;
    core::with_threads(options.jobs, [&] { nsga2(costs, options, front); });
    return front;
}

}  // namespace

Front find_front(const Costs& costs, const FrontOptions& options) {
    validate(options);
    const Free free(options.bounds);
    if (free.all()) return search(costs, options);
    if (free.none()) return {.members = {free.with_fixed({})}, .evaluations = 0};
    FrontOptions of_free = options;
    of_free.bounds = free.of(options.bounds);
    for (std::vector<double>& seed : of_free.seeds) seed = free.of(seed);
    const Costs costs_of_free = [&](std::span<const double> some) { return costs(free.with_fixed(some)); };
    Front front = search(costs_of_free, of_free);
    for (std::vector<double>& member : front.members) member = free.with_fixed(member);
    return front;
}

}  // namespace fusee::search::codesign
