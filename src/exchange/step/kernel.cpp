#include "kernel.h"

#include "step_model.h"

const fusee::exchange::StepKernel* fusee_step_kernel() {
    using namespace fusee::exchange;
    static constexpr StepKernel kernel{write_step,    read_step,      write_step_assembly,         read_step_assembly,
                                       interferences, read_step_mesh, [] { (void)step_session(); }};
    return &kernel;
}
