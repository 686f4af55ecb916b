#include <fmt/format.h>

#include "layout.h"
#include "measure.h"

namespace fusee::assembly {

namespace {

core::Findings measure_joint_bearing_load(const Assembly& assembly, const Allowed& allowed) {
    const auto load = frame_load(assembly);
    if (!load) return {};
    const double bore = core::mm_from_m(assembly.drive.k_pe->options.hub.bore_diameter), rating = bearing_rating(bore);
    if (rating <= 0.0)
        return {core::not_judged("joint.bearing_load", fmt::format("the static load rating of a bearing for {:g} mm is not known", bore),
                                 "k_pe.hub.bore_mm of 3, 4, 5, 6, 8, 10 or 12")};
    core::Findings all;
    for (const FrameLoad::Bearing& bearing : load->bearings) {
        core::Finding f = checks::compare(rating / bearing.force, {allowed("required"), allowed("review")});
        f.what = fmt::format("static safety of the ball bearing of {}: C0 {:.0f} N, load {:.0f} N", bearing.of, rating, bearing.force);
        f.where = "bearings";
        if (const auto larger = bore_of_rating(f.allowed * bearing.force))
            f.suggestion = core::change("k_pe.hub.bore_mm", core::number(*larger));
        f.suggestion.or_else("bearings of a heavier series");
        all.push_back(std::move(f));
    }
    return all;
}

}  // namespace

Rule joint_bearing_load() {
    return {{"joint.bearing_load",
             "a ball bearing that its shaft dents",
             "static load rating C0 (ISO 76) over the largest load of each bearing of the frame",
             "SKF: ball bearings 0.5 at least, 1 for quiet running; C0: SKF, of 6001 NTN",
             {required(kAtLeast, "", 0.5), review(kAtLeast, "", 1.0)}},
            measure_joint_bearing_load};
}

}  // namespace fusee::assembly
