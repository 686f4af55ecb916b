// fusee: all commands.
#include <string_view>

#include "fusee/exchange/mesh_file.h"
#include "program.h"

namespace fusee::app {

namespace {

constexpr HeldCommand kHeld[] = {
    {"init", add_init},
    {"make", add_make},
    {"watch", add_watch},
    {"check", add_check},
    {"fix", add_fix},
    {"batch", add_batch},
    {"query", add_query},
    {"design", add_design},
    {"springs", add_springs},
    {"budget", add_budget},
    {"render", add_render},
    {"coupons", add_coupons},
    {"calibrate", add_calibrate},
    {"simulate", add_simulate},
    {"case-template", add_case_template},
    {"identify", add_identify},
    {"diagnose", add_diagnose},
    {"predict", add_predict},
    {"blind", add_blind},
    {"paper", add_paper},
    {"explain", add_explain},
    {"keys", add_keys},
    {"rules", add_rules},
    {"completion", add_completion},
    {"man", add_man},
};

}  // namespace

}  // namespace fusee::app

int main(int argc, char** argv) {
    if (argc == 3 && std::string_view(argv[1]) == fusee::exchange::kReadMesh)
        return fusee::exchange::serve_mesh_file(argv[2]);  // for mesh_check.cpp
    return fusee::app::run_program(argc, argv, fusee::app::kHeld);
}
