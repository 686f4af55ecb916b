#include "engine_case.h"

#include <nlohmann/json.hpp>

#include "fusee/core/companion.h"
#include "fusee/core/error.h"
#include "fusee/core/process.h"
#include "label_json.h"

namespace fusee::blind {

namespace {

constexpr std::chrono::seconds kMostTime{1800};  // of a case, which takes seconds in MuJoCo and a minute in Siconos

}  // namespace

const std::vector<std::string>& maker_names() {
    static const std::vector<std::string> names{"plant", "model", "mujoco", "siconos"};
    return names;
}

bool is_engine(Maker maker) { return maker == Maker::kMujoco || maker == Maker::kSiconos; }

std::string engine_program(Maker maker) {
    const std::string name = "fusee-" + to_string(maker) + "-plant";
    std::string program = core::companion_program(name);
    if (!program.empty()) return program;
    const bool mujoco = maker == Maker::kMujoco;
    const std::string package = mujoco ? "libmujoco-dev" : "libsiconos-kernel-dev";
    throw core::InvalidInput("plant", to_string(maker) + ": the program " + name + " is neither beside fusee nor on PATH",
                             (mujoco ? "the package fusee-mujoco; or, as root, " : "as root, ") + ("apt-get install " + package) +
                                 ", then build everything again");
}

void write_engine_case(Maker maker, const std::filesystem::path& folder, std::uint64_t seed, std::size_t index, const Label& label) {
    const nlohmann::json order{{"seed", seed}, {"index", index}, {"folder", folder.string()}, {"effects", effects_json(label)}};
    const std::string name = engine_program(maker);
    core::Companion program({name}, "", {}, folder.string());
    std::string answer;
    if (program.ask(order.dump(), kMostTime, answer) != core::Companion::End::kAnswered || answer != "written")
        throw core::InvalidInput("plant", name + " gave no " + label.case_name + ": " + core::last_words(program.errors()),
                                 "a rig that this engine can move");
}

}  // namespace fusee::blind
