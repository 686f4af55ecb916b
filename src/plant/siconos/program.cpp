#include "engine_program.h"
#include "fusee/plant/case_files.h"
#include "siconos/engine.h"

// fusee-siconos-plant
int main(int count, char** words) {
    using namespace fusee::plant;
    return write_cases(count, words, "siconos", [](Random&) { return std::make_unique<SiconosEngine>(); });
}
