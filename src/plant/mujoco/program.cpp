#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>

#include "engine_program.h"
#include "fusee/plant/case_files.h"
#include "mujoco/engine.h"

// fusee-mujoco-plant
int main(int count, char** words) {
    // MuJoCo's own handlers write a file, and read a key.
    mju_user_error = [](const char* text) {
        std::fprintf(stderr, "MuJoCo: %s\n", text);
        std::_Exit(1);
    };
    mju_user_warning = [](const char* text) { std::fprintf(stderr, "MuJoCo: %s\n", text); };
    using namespace fusee::plant;
    return write_cases(count, words, "mujoco", [](Random& random) { return std::make_unique<MujocoEngine>(draw_softness(random)); });
}
