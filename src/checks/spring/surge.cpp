#include "means.h"

namespace fusee::checks {

namespace {

core::Findings measure_spring_surge(const Design& design, const Allowed& allowed) {
    const spring::BaseSpring& s = design.spring;
    const double surge = spring::surge_frequency(s);
    core::Finding f = compare(surge / s.motion, {allowed("required"), allowed("review")});
    f.what = fmt::format("natural frequency of the coils, {:.1f} Hz, over that of the fastest motion, {:g} Hz", surge, s.motion);
    f.suggestion = change(design, "spring.motion_Hz", down(surge / f.allowed)).or_else("a spring of fewer turns on thicker wire");
    return {f};
}

}  // namespace

Rule spring_surge() {
    return {"spring.surge",
            "coils that resonate with the motion, so that force and stress depend on time",
            "lowest natural frequency of the coils, 0.5 sqrt(k/m), over spring.motion_Hz",
            "engineersedge: 15 to 20 times; amesweb: at least 13",
            {required(kAtLeast, "", 13.0), review(kAtLeast, "", 20.0)},
            measure_spring_surge,
            nullptr,
            {need::kWire, need::kCoil, need::kActiveCoils}};
}

}  // namespace fusee::checks
