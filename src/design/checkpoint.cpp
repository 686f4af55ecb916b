#include "checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>

#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/json.h"

namespace fusee::design {

namespace {

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

}  // namespace

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

}  // namespace fusee::design
