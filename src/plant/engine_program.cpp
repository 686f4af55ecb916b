#include "engine_program.h"

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "fusee/core/file.h"
#include "fusee/core/json.h"
#include "fusee/plant/case_files.h"

namespace fusee::plant {

namespace {

constexpr std::uint64_t kEngine = 501;  // the stream of random numbers

Effect effect_of(const core::JsonNode& node) {
    Effect effect{node["id"].text(), node["side"].text(), node["size"].number(), {}};
    for (const auto& [name, value] : node["extra"].members()) effect.extra.emplace_back(name, value.number());
    return effect;
}

void write_case(const core::JsonNode& order, const DrawEngine& draw) {
    const std::uint64_t seed = order["seed"].count(), index = order["index"].count();
    const std::filesystem::path folder = order["folder"].text();
    std::vector<Effect> effects;
    for (const core::JsonNode& effect : order["effects"].cells()) effects.push_back(effect_of(effect));
    Random random(seed, index, kEngine);
    core::make_folder(folder / "heldout");
    for (const auto& [name, bytes] : make_case(seed, index, effects, *draw(random))) core::write_file(folder / name, bytes);
}

/// The stream of the answers. What a library prints to standard output goes to standard error from now on.
std::FILE* answers_alone() {
    std::FILE* answers = ::fdopen(::dup(STDOUT_FILENO), "w");
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    return answers;
}

}  // namespace

int write_cases(int count, char** words, const char* name, const DrawEngine& draw) {
    if (count != 1) {
        std::fprintf(stderr, "%s: no arguments; the rig of fusee blind make --plant %s\n", words[0], name);
        return 2;
    }
    std::FILE* const answers = answers_alone();
    try {
        for (std::string line; std::getline(std::cin, line);) {
            const nlohmann::ordered_json json = core::parse_json(line, "order");
            write_case(core::JsonNode(json, "order"), draw);
            std::fputs("written\n", answers);
            std::fflush(answers);
        }
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 2;
    }
    return 0;
}

}  // namespace fusee::plant
