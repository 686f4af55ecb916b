// The paper's springs from an installed fusee, with a known answer: the capstan travels 0.77304375431332 rad over the loads.
#include <cmath>
#include <cstdio>

#include "fusee/spring/laws.h"

int main() {
    fusee::spring::StictionLawOptions options;
    options.k = 0.69;
    options.u = 0.0027;
    options.c = 0.30;
    options.start_torque = 0.5;
    options.end_torque = 1.5;
    const auto law = fusee::spring::make_stiction_law(options);
    if (!law) return 1;
    const double travel = (*law)->angles().width();
    std::printf("travel %.14f rad\n", travel);
    return std::abs(travel - 0.77304375431332) < 1e-12 ? 0 : 1;
}
