#include "described.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "fusee/core/companion.h"
#include "fusee/core/error.h"
#include "fusee/core/json.h"
#include "fusee/core/lists.h"
#include "fusee/core/process.h"

namespace fusee::simulator {

namespace {

constexpr const char* kCompanion = "fusee-mujoco";

std::vector<double> numbers_of(const core::JsonNode& node, std::size_t count) {
    auto numbers = core::each<double>(node.cells(), &core::JsonNode::number);
    if (numbers.size() != count) node.refuse(fmt::format("{} numbers", count));
    return numbers;
}

Parameter described_parameter(const std::string& name, const core::JsonNode& node) {
    Parameter own{name, node.has("unit") ? node["unit"].text() : unit_in(name)};
    own.nominal = node["nominal"].number();
    own.relative = node.has("tolerance");
    if (own.relative) own.sigma = std::abs(own.nominal) * node["tolerance"].number_within(1e-9, 0.5);
    if (node.has("tolerance_abs")) own.sigma = node["tolerance_abs"].number_at_least(0.0);
    return own;
}

Effect described_effect(const std::string& id, const core::JsonNode& node, const std::vector<Parameter>& parameters) {
    Effect own{id, {}, {}, {}, node["meaning"].text(), node["remedy"].text()};
    for (const core::JsonNode& freed : node["frees"].cells(1)) {
        const Parameter* found = core::find_by(parameters, &Parameter::name, freed.text());
        if (found == nullptr) freed.refuse("the name of a parameter");
        own.frees.push_back(static_cast<std::size_t>(found - parameters.data()));
    }
    const std::size_t count = own.frees.size();
    own.usual = numbers_of(node["usual"], count);
    const std::vector<double> ends = numbers_of(node["range"], 2 * count);
    for (std::size_t k = 0; k < count; ++k) own.ranges.push_back({ends[2 * k], ends[2 * k + 1]});
    return own;
}

void read_description(const core::JsonNode& root, Case& to) {
    for (const auto& [name, node] : root["parameters"].members()) to.parameters.push_back(described_parameter(name, node));
    if (!root.has("effects")) return;
    for (const auto& [id, node] : root["effects"].members()) to.effects.push_back(described_effect(id, node, to.parameters));
}

}  // namespace

std::string mujoco_companion(const std::string& place) {
    if (std::string program = core::companion_program(kCompanion); !program.empty()) return program;
    throw core::InvalidInput(place, fmt::format("needs MuJoCo, and the program {} is neither beside fusee nor on PATH", kCompanion),
                             "the package fusee-mujoco; or, as root, apt-get install libmujoco-dev, then build fusee again; or "
                             "model.command: a program that speaks for "
                             "another MuJoCo (docs/guides/my-mujoco-model.md)");
}

void ask_description(const std::string& place, Case& to) {
    const auto fail = [&](const std::string& what) {
        throw core::InvalidInput(place, what, "a model that its program loads and describes (docs/guides/my-mujoco-model.md)");
    };
    core::Companion process(to.command, to.model.parent_path(), {"PYTHONUNBUFFERED=1"}, place);
    std::string line;
    const core::Companion::End end = process.ask(R"({"id": 0, "describe": true})", to.timeout, line);
    if (end != core::Companion::End::kAnswered)
        fail(fmt::format("{} gave no description{}", to.command.front(),
                         process.errors().empty() ? "" : "; on standard error: " + core::last_words(process.errors())));
    std::string refused;
    try {
        const nlohmann::ordered_json json = core::parse_json(line, "description");
        const core::JsonNode root(json, "description");
        if (root.has("error"))
            refused = root["error"].text();
        else
            read_description(root, to);
    } catch (const core::InputError& e) {
        refused = e.what();
    }
    if (!refused.empty()) fail(refused);
}

}  // namespace fusee::simulator
