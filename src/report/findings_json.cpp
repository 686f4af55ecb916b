#include "findings_json.h"

namespace fusee::report {

nlohmann::ordered_json findings_json(const core::Findings& findings) {
    using Json = nlohmann::ordered_json;
    Json all = Json::array();
    for (const core::Finding& f : findings) {
        Json j{{"rule", f.rule},
               {"severity", core::to_string(f.severity)},
               {"what", f.what},
               {"measured", f.measured},
               {"bound", f.bound == core::Bound::kAtMost ? "at most" : "at least"},
               {"allowed", f.allowed},
               {"unit", f.unit},
               {"where", f.where}};
        if (f.place) j["place"] = {{"angle_rad", f.place->angle}, {"point_mm", f.place->point_mm}};
        j["suggestion"] = f.suggestion;
        j["source"] = f.source;
        for (const core::OverriddenLimit& o : f.overridden)
            j["overridden"].push_back(
                {{"limit", o.limit}, {"value", o.value}, {"default", o.normal}, {"unit", o.unit}, {"reason", o.reason}});
        all.push_back(std::move(j));
    }
    return all;
}

}  // namespace fusee::report
