#include "bindings.h"
#include "fusee/core/provenance.h"

PYBIND11_MODULE(_fusee, module) {
    using namespace fusee::python;
    module.doc() = "Springs of antagonistic variable-stiffness joints as cams, and the diagnosis of built joints.";
    module.attr("__version__") = fusee::core::version();
    bind_errors(module);
    bind_findings(module);
    bind_profile(module);
    bind_law(module);
    bind_simulation(module);
    bind_parts(module);
    bind_make(module);
    bind_search(module);
    bind_fix(module);
    bind_gap_case(module);
    bind_simulator(module);
    bind_diagnosis(module);
    bind_commands(module);
}
