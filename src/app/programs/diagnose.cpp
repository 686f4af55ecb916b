// fusee-diagnose: the commands that need nothing but measurements. `./fusee` builds it for them alone.
#include "program.h"
#include "redesign_step.h"

namespace fusee::app {

RedesignStep redesign_step(const std::filesystem::path& profile, const std::filesystem::path& file, const std::filesystem::path&, bool) {
    if (!profile.empty() || !file.empty()) continue_in_whole_program();
    return {};
}

RigJoint rig_joint(const std::filesystem::path&, const std::filesystem::path&) { return {}; }

namespace {

constexpr HeldCommand kHeld[] = {{"identify", add_identify}, {"diagnose", add_diagnose}, {"predict", add_predict}};

}  // namespace

}  // namespace fusee::app

int main(int argc, char** argv) { return fusee::app::run_program(argc, argv, fusee::app::kHeld); }
