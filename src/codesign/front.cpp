#include "front.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>

#include "fusee/core/error.h"
#include "fusee/core/parallel.h"
#include "nsga2.h"

namespace fusee::codesign {

namespace {

namespace fs = std::filesystem;

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
        std::vector<Value> some;
        for (const std::size_t i : free_) some.push_back(values[i]);
        return some;
    }
    /// All of them, the others at their only value.
    [[nodiscard]] std::vector<double> with_fixed(std::span<const double> some) const {
        std::vector<double> values;
        for (const core::Range& range : bounds_) values.push_back(range.low);
        for (std::size_t i = 0; i < free_.size(); ++i) values[free_[i]] = some[i];
        return values;
    }

private:
    const std::vector<core::Range>& bounds_;
    std::vector<std::size_t> free_;
};

/// Where the module may be: beside the program or Python's module, in the library folder of their prefix or build, or where it was
/// installed.
std::vector<fs::path> module_files() {
    std::vector<fs::path> files;
    Dl_info self{};
    if (::dladdr(reinterpret_cast<const void*>(&find_front), &self) != 0 && self.dli_fname != nullptr) {
        std::error_code ignored;
        const fs::path folder = fs::canonical(self.dli_fname, ignored).parent_path();
        for (const char* below : {"", "../" FUSEE_LIBDIR "/fusee", "../../" FUSEE_LIBDIR "/fusee"})
            if (!folder.empty()) files.push_back((folder / below / "fusee_nsga2.so").lexically_normal());
    }
    files.emplace_back(FUSEE_FULL_LIBDIR "/fusee/fusee_nsga2.so");
    return files;
}

/// pagmo takes 70 ms to start: it is loaded when a front is searched, and stays. @throws IoError naming where the module is missing
decltype(&fusee_nsga2) nsga2() {
    static const auto loaded = [] {
        std::string reasons;
        for (const fs::path& file : module_files()) {
            if (void* module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL))
                if (void* function = ::dlsym(module, "fusee_nsga2")) return reinterpret_cast<decltype(&fusee_nsga2)>(function);
            reasons += fmt::format("{}{}", reasons.empty() ? "" : "; ", ::dlerror());
        }
        throw core::IoError("fusee_nsga2.so", reasons);
    }();
    return loaded;
}

Front search(const Costs& costs, const FrontOptions& options) {
    Front front;
    const auto function = nsga2();
    core::with_threads(options.jobs, [&] { function(costs, options, front); });
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

}  // namespace fusee::codesign
