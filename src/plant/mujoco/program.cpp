#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "engine.h"
#include "fusee/core/error.h"
#include "fusee/core/file.h"
#include "fusee/core/json.h"
#include "fusee/plant/case_files.h"

// fusee-mujoco-plant: for each line {"seed": 1, "index": 0, "folder": "case000", "effects": [...]} writes a gap case whose rig moves in
// MuJoCo, and answers "written". fusee blind make --plant mujoco asks it: on a command line any user would see the sealed effects.
namespace fusee::plant {

namespace {

constexpr std::uint64_t kSoftness = 501;  // a stream that no case and no label is drawn from

Effect effect_of(const core::JsonNode& node) {
    Effect effect{node["id"].text(), node["side"].text(), node["size"].number(), {}};
    for (const auto& [name, value] : node["extra"].members()) effect.extra.emplace_back(name, value.number());
    return effect;
}

void write_case(const core::JsonNode& order) {
    const std::uint64_t seed = order["seed"].count(), index = order["index"].count();
    const std::filesystem::path folder = order["folder"].text();
    std::vector<Effect> effects;
    for (const core::JsonNode& effect : order["effects"].cells()) effects.push_back(effect_of(effect));
    Random random(seed, index, kSoftness);
    core::make_folder(folder / "heldout");
    for (const auto& [name, bytes] : make_case(seed, index, effects, MujocoEngine(draw_softness(random))))
        core::write_file(folder / name, bytes);
}

}  // namespace

}  // namespace fusee::plant

int main(int count, char** words) {
    // MuJoCo's own handlers write a file, and read a key.
    mju_user_error = [](const char* text) {
        std::fprintf(stderr, "MuJoCo: %s\n", text);
        std::_Exit(1);
    };
    mju_user_warning = [](const char* text) { std::fprintf(stderr, "MuJoCo: %s\n", text); };
    if (count != 1) {
        std::fprintf(stderr, "%s: no arguments; the rig of fusee blind make --plant mujoco, MuJoCo %s\n", words[0], mj_versionString());
        return 2;
    }
    try {
        for (std::string line; std::getline(std::cin, line);) {
            const nlohmann::ordered_json json = fusee::core::parse_json(line, "order");
            fusee::plant::write_case(fusee::core::JsonNode(json, "order"));
            std::cout << "written" << std::endl;
        }
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 2;
    }
    return 0;
}
