#include "kernel.h"

const fusee::exchange::brep::Kernel* fusee_brep_kernel() {
    using namespace fusee::exchange;
    static constexpr brep::Kernel kernel{brep::build, brep::extruded, brep::mirrored, brep::outline_splines};
    return &kernel;
}
