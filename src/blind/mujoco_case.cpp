#include "mujoco_case.h"

#include <nlohmann/json.hpp>

#include "fusee/core/companion.h"
#include "fusee/core/error.h"
#include "fusee/core/process.h"
#include "label_json.h"

namespace fusee::blind {

namespace {

constexpr std::chrono::seconds kMostTime{600};  // of a case, which takes 10 s

}  // namespace

std::string mujoco_plant() {
    std::string program = core::companion_program("fusee-mujoco-plant");
    if (program.empty())
        throw core::InvalidInput("plant", "mujoco: the program fusee-mujoco-plant is neither beside fusee nor on PATH",
                                 "the package fusee-mujoco; or, as root, apt-get install libmujoco-dev, then build everything again");
    return program;
}

void write_mujoco_case(const std::filesystem::path& folder, std::uint64_t seed, std::size_t index, const Label& label) {
    const nlohmann::json order{{"seed", seed}, {"index", index}, {"folder", folder.string()}, {"effects", effects_json(label)}};
    core::Companion program({mujoco_plant()}, "", {}, folder.string());
    std::string answer;
    if (program.ask(order.dump(), kMostTime, answer) != core::Companion::End::kAnswered)
        throw core::InvalidInput("plant", "fusee-mujoco-plant gave no " + label.case_name + ": " + core::last_words(program.errors()),
                                 "a rig that MuJoCo can move");
}

}  // namespace fusee::blind
