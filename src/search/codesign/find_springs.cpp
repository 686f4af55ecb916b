#include <algorithm>

#include "fusee/core/error.h"
#include "fusee/search/design.h"

namespace fusee::search::codesign {

namespace {

design::Method method_named(const std::string& name) {
    const auto found = std::ranges::find(design::kMethodNames, name);
    if (found == design::kMethodNames.end()) throw core::InvalidInput("method", name, "algorithm_1, co_design or pareto");
    return static_cast<design::Method>(found - design::kMethodNames.begin());
}

}  // namespace

void change_search(design::SearchOptions& search, const SearchChanges& changes) {
    if (changes.method) search.method = method_named(*changes.method);
    search.population = changes.population.value_or(search.population);
    search.generations = changes.generations.value_or(search.generations);
    search.seed = changes.seed.value_or(search.seed);
}

RunResult find_springs(const profile::Profile& profile, const RunOptions& options) {
    switch (profile.search.method) {
        case design::Method::kAlgorithm1:
            return run_algorithm_1(profile, options);
        case design::Method::kCoDesign:
            return run_co_design(profile, options);
        case design::Method::kPareto:
            break;
    }
    return run_pareto(profile, options);
}

}  // namespace fusee::search::codesign
