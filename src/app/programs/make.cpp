// fusee-make: the commands that need nothing but designs. `./fusee` builds it for them alone.
#include "mesh_check.h"
#include "program.h"

namespace fusee::app {

MeshCheck check_mesh(const std::filesystem::path&, const std::vector<Machine>&, const std::filesystem::path&, const std::filesystem::path&,
                     bool, unsigned) {
    continue_in_whole_program();
}

namespace {

constexpr HeldCommand kHeld[] = {
    {"make", add_make},       {"check", add_check},         {"springs", add_springs}, {"budget", add_budget},
    {"coupons", add_coupons}, {"calibrate", add_calibrate}, {"keys", add_keys},
};

}  // namespace

}  // namespace fusee::app

int main(int argc, char** argv) { return fusee::app::run_program(argc, argv, fusee::app::kHeld); }
