#include "fusee/design/evolution.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/json.h"
#include "fusee/core/parallel.h"
#include "fusee/math/stream.h"

namespace fusee::design {

namespace {

/// A population after some generations: with the options, all that the next generation depends on.
struct Generation {
    int number = 0;               ///< generations done; 0: the first population
    std::vector<double> members;  ///< one after the other
    std::vector<double> costs;
    std::size_t evaluations = 0;
    std::vector<double> history;
};

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "fusee evolution 1";
constexpr int kCheckpointDepth = 4;
constexpr std::size_t kLargestCheckpoint = 100'000'000;  // bytes of a checkpoint

/// Options that must be equal for a search to continue as if it had never stopped. Numbers are written with all significant digits.
Json identity(const EvolutionOptions& options) {
    Json bounds = Json::array();
    for (const core::Range& range : options.bounds) bounds.push_back({range.low, range.high});
    return {{"format", kFormat},        {"problem", options.problem},     {"bounds", bounds},    {"population", options.population},
            {"weight", options.weight}, {"crossover", options.crossover}, {"seed", options.seed}};
}

void require_same(const Json& stored, const EvolutionOptions& options) {
    const Json wanted = identity(options);
    for (const auto& [key, value] : wanted.items()) {
        const Json found = stored.value(key, Json());
        if (found != value)
            throw core::InvalidInput(options.checkpoint.string() + ": " + key, found.dump(),
                                     value.dump() + " in this search: resume with the options of the stopped search, or start a new one");
    }
}

bool plausible(const Generation& state, const EvolutionOptions& options) {
    const std::size_t n = static_cast<std::size_t>(options.population), dimension = options.bounds.size();
    if (state.number < 0 || state.members.size() != n * dimension || state.costs.size() != n) return false;
    if (state.history.size() != static_cast<std::size_t>(state.number) + 1) return false;
    for (std::size_t i = 0; i < state.members.size(); ++i)
        if (!options.bounds[i % dimension].holds(state.members[i])) return false;
    return std::none_of(state.costs.begin(), state.costs.end(), [](double cost) { return std::isnan(cost); });
}

/// A checkpoint is replaced again and again: a link would be, too.
void refuse_link(const std::filesystem::path& file) {
    std::error_code ignored;
    if (std::filesystem::is_symlink(std::filesystem::symlink_status(file, ignored)))
        throw core::IoError(file.string(), "is a link, and fusee follows only links that you name yourself: remove it");
}

Json parsed(const std::string& bytes, const std::string& file) {
    try {
        return core::parse_json(bytes, file);
    } catch (const core::InvalidInput& e) {
        throw core::IoError(file, std::string("is a damaged checkpoint: ") + e.what());
    }
}

/// @param finished the search is complete and may be replaced by another @throws core::IoError
void write_checkpoint(const EvolutionOptions& options, const Generation& state, bool finished) {
    Json json = identity(options);
    json["finished"] = finished;
    json["generation"] = state.number;
    json["evaluations"] = state.evaluations;
    json["members"] = state.members;
    json["costs"] = state.costs;
    json["history"] = state.history;
    core::write_file(options.checkpoint, json.dump(1) + "\n");
}

/// Checks that a new search may replace the checkpoint. @throws core::IoError if it cannot be written, if the file is not a checkpoint, or
/// if it holds a stopped search and options.force is not set
void require_replaceable(const EvolutionOptions& options) {
    const std::string file = options.checkpoint.string();
    core::require_writable(options.checkpoint);
    refuse_link(options.checkpoint);
    if (!std::filesystem::exists(options.checkpoint)) return;
    const auto shallow = [](int depth, Json::parse_event_t, const Json&) { return depth <= kCheckpointDepth; };
    const Json json = Json::parse(core::read_file(options.checkpoint, kLargestCheckpoint), shallow, false);
    if (!json.is_object() || json.value("format", Json()) != kFormat)
        throw core::IoError(file, "fusee did not make this file: move it, or choose another folder");
    if (!options.force && json.value("finished", Json()) != true)
        throw core::IoError(file,
                            fmt::format("holds a search that was stopped after {} generations: continue it with --resume, or replace it "
                                        "with --force",
                                        json.value("generation", Json()).dump()));
}

/// Nothing if there is no such file.
/// @throws core::InvalidInput naming the option that differs in the checkpoint; core::IoError if it is damaged
std::optional<Generation> read_checkpoint(const EvolutionOptions& options) {
    refuse_link(options.checkpoint);
    if (!std::filesystem::exists(options.checkpoint)) return std::nullopt;
    const std::string file = options.checkpoint.string();
    const Json json = parsed(core::read_file(options.checkpoint, kLargestCheckpoint), file);
    if (!json.is_object() || json.value("format", Json()) != kFormat)
        throw core::IoError(file, "is not a checkpoint of a search, or is damaged");
    require_same(json, options);
    Generation state;
    try {
        json.at("generation").get_to(state.number);
        json.at("evaluations").get_to(state.evaluations);
        json.at("members").get_to(state.members);
        json.at("costs").get_to(state.costs);
        json.at("history").get_to(state.history);
    } catch (const Json::exception& e) {
        throw core::IoError(file, std::string("is a damaged checkpoint: ") + e.what());
    }
    if (!plausible(state, options)) throw core::IoError(file, "is a damaged checkpoint: its population does not match its size or box");
    return state;
}

constexpr int kLeastPopulation = 8, kMost = 1'000'000;
constexpr double kDither = 0.2;

void validate_options(const EvolutionOptions& o) {
    if (o.bounds.empty()) throw core::InvalidInput("bounds", "none", "a range for each variable");
    constexpr double kLargest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < o.bounds.size(); ++i) {
        core::require_within(fmt::format("bounds[{}].low", i), o.bounds[i].low, -kLargest, kLargest);
        core::require_within(fmt::format("bounds[{}].high", i), o.bounds[i].high, o.bounds[i].low, kLargest);
    }
    core::require_within("population", o.population, kLeastPopulation, kMost);
    core::require_within("generations", o.generations, 1, kMost);
    core::require_positive("weight", o.weight);
    core::require_within("weight", o.weight, 0.0, 2.0);
    core::require_within("crossover", o.crossover, 0.0, 1.0);
    core::require_within("tolerance", o.tolerance, 0.0, kLargest);
    core::require_within("checkpoint_every", o.checkpoint_every, 1, kMost);
    if (o.resume && o.checkpoint.empty()) throw core::InvalidInput("resume", "no checkpoint", "the file to continue from");
}

/// Draws of one individual: dither, the variable that always crosses over, two for each variable; those of the partners come last, because
/// their number is open: they are drawn until they differ.
enum Draw : std::uint64_t { kDitherDraw = 0, kSureDraw = 1, kVariableDraw = 2, kPartnerDraw = std::uint64_t{1} << 32 };

/// Three members that differ from each other and from `self`.
std::array<int, 3> partners(const math::Stream& random, int population, int self) {
    std::array<int, 3> others{self, self, self};
    std::uint64_t draw = kPartnerDraw;
    for (std::size_t k = 0; k < others.size(); ++k) {
        int pick = self;
        while (pick == self || std::find(others.begin(), others.begin() + k, pick) != others.begin() + k)
            pick = random.index(draw++, population);
        others[k] = pick;
    }
    return others;
}

/// One search: the population, and the rules that make the next one.
class Search {
public:
    Search(const Cost& cost, const EvolutionOptions& options) : cost_(cost), o_(options), dimension_(options.bounds.size()) {}

    void begin() {
        state_ = {};
        state_.members.resize(static_cast<std::size_t>(o_.population) * dimension_);
        for (std::size_t i = 0; i < state_.members.size(); ++i) {
            const core::Range& range = o_.bounds[i % dimension_];
            const double share = math::Stream(o_.seed, 0, i / dimension_).uniform(kVariableDraw + i % dimension_);
            state_.members[i] = std::clamp(range.low + share * range.width(), range.low, range.high);
        }
        state_.costs = evaluated(state_.members);
        note_best();
    }
    void resume(Generation state) { state_ = std::move(state); }

    void step() {
        const std::size_t best = this->best();
        std::vector<double> trials;
        trials.reserve(state_.members.size());
        for (int i = 0; i < o_.population; ++i) append_trial(i, best, trials);
        const std::vector<double> costs = evaluated(trials);
        for (std::size_t i = 0; i < costs.size(); ++i) {
            if (costs[i] > state_.costs[i]) continue;
            state_.costs[i] = costs[i];
            std::copy_n(trials.begin() + offset(i), dimension_, state_.members.begin() + offset(i));
        }
        ++state_.number;
        note_best();
    }

    [[nodiscard]] bool finished() const {
        const auto [least, most] = std::minmax_element(state_.costs.begin(), state_.costs.end());
        return state_.number >= o_.generations || (o_.tolerance > 0.0 && *most - *least <= o_.tolerance);
    }
    [[nodiscard]] const Generation& state() const { return state_; }
    [[nodiscard]] EvolutionResult result(bool interrupted) const {
        const auto row = state_.members.begin() + offset(best());
        return {{row, row + static_cast<std::ptrdiff_t>(dimension_)},
                state_.costs[best()],
                state_.evaluations,
                state_.number,
                interrupted,
                state_.history};
    }

private:
    [[nodiscard]] std::ptrdiff_t offset(std::size_t member) const { return static_cast<std::ptrdiff_t>(member * dimension_); }
    [[nodiscard]] std::size_t best() const {
        return static_cast<std::size_t>(std::min_element(state_.costs.begin(), state_.costs.end()) - state_.costs.begin());
    }
    void note_best() { state_.history.push_back(state_.costs[best()]); }

    std::vector<double> evaluated(const std::vector<double>& rows) {
        const auto row = [&](std::size_t i) { return std::span(rows.data() + offset(i), dimension_); };
        std::vector<double> costs(rows.size() / dimension_);
        core::parallel_for(costs.size(), o_.jobs, [&](std::size_t i) {
            const double cost = cost_(row(i));
            costs[i] = std::isfinite(cost) ? cost : std::numeric_limits<double>::max();
        });
        state_.evaluations += costs.size();
        for (std::size_t i = 0; o_.observe && i < costs.size(); ++i) o_.observe(row(i), costs[i]);
        return costs;
    }

    /// v = r1 + F (best - r1) + F (r2 - r3), crossed with the member. A value outside the box is redrawn between its base and the bound.
    void append_trial(int self, std::size_t best, std::vector<double>& trials) const {
        const math::Stream random(o_.seed, static_cast<std::uint64_t>(state_.number) + 1, static_cast<std::uint64_t>(self));
        const std::array<int, 3> others = partners(random, o_.population, self);
        const double weight = o_.weight * (1.0 + kDither * (2.0 * random.uniform(kDitherDraw) - 1.0));
        const std::size_t sure = static_cast<std::size_t>(random.index(kSureDraw, static_cast<int>(dimension_)));
        const auto at = [&](auto member, std::size_t j) { return state_.members[static_cast<std::size_t>(member) * dimension_ + j]; };
        for (std::size_t j = 0; j < dimension_; ++j) {
            if (j != sure && random.uniform(kVariableDraw + 2 * j) >= o_.crossover) {
                trials.push_back(at(self, j));
                continue;
            }
            const double base = at(others[0], j);
            const double wanted = base + weight * (at(best, j) - base + at(others[1], j) - at(others[2], j));
            const core::Range& box = o_.bounds[j];
            const double bound = std::clamp(wanted, box.low, box.high);
            const double inside = bound == wanted ? wanted : base + random.uniform(kVariableDraw + 2 * j + 1) * (bound - base);
            trials.push_back(std::clamp(inside, box.low, box.high));
        }
    }

    const Cost& cost_;
    const EvolutionOptions& o_;
    std::size_t dimension_;
    Generation state_;
};

}  // namespace

EvolutionResult evolve(const Cost& cost, const EvolutionOptions& options) {
    validate_options(options);
    Search search(cost, options);
    std::optional<Generation> stored;
    if (options.resume)
        stored = read_checkpoint(options);
    else if (!options.checkpoint.empty())
        require_replaceable(options);
    if (stored)
        search.resume(std::move(*stored));
    else
        search.begin();
    const auto stopped = [&] { return options.stop && options.stop(); };
    while (!search.finished() && !stopped()) {
        search.step();
        const Generation& state = search.state();
        if (options.progress) options.progress(state.number, state.history.back());
        if (!options.checkpoint.empty() && state.number % options.checkpoint_every == 0) write_checkpoint(options, state, false);
    }
    if (!options.checkpoint.empty()) write_checkpoint(options, search.state(), search.finished());
    return search.result(!search.finished());
}

}  // namespace fusee::design
