#include "key.h"

namespace fusee::profile {

namespace {

#define FIELD(member) \
    [](auto& p) -> auto& { return p.member; }

std::vector<Key> search_keys() {
    return {
        choice("design.method", {design::kMethodNames.begin(), design::kMethodNames.end()},
               "method of `fusee design`: the paper's Algorithm 1; law, springs and cams together; a front of such designs",
               FIELD(search.method)),
        integer("design.population", within(8, 100000), "members of a generation", FIELD(search.population)),
        integer("design.generations", within(1, 1000000), "after the first population", FIELD(search.generations)),
        integer("design.seed", within(0, 1e9), "the same seed gives the same result on any number of threads", FIELD(search.seed)),
    };
}

std::vector<Key> algorithm_1_keys() {
    const Limits weight = within(0, 1e9);
    return {
        range("algorithm_1.k_per_Nm_rad", kPerNmRad, above(0, 1e6), "box of k: lowest, highest", FIELD(algorithm_1.k)),
        range("algorithm_1.u_Nm", kNm, within(-1e3, 1e3), "box of u; u and -u are the same springs", FIELD(algorithm_1.u)),
        range("algorithm_1.c_Nm", kNm, within(-1e3, 1e3), "box of C", FIELD(algorithm_1.c)),
        integer("algorithm_1.torques", within(2, 100000), "levels of the co-contraction, from law.start_torque_Nm to rig.peak_torque_Nm",
                FIELD(algorithm_1.torques)),
        number("algorithm_1.wanted_travel_deg", kDeg, within(0, 36000), "wanted capstan angle between them; 0: that of the profile's law",
               FIELD(algorithm_1.wanted_travel)),
        number("algorithm_1.joint_range_deg", kDeg, above(0, 36000), "range of the joint, the greatest dead-band",
               FIELD(algorithm_1.joint_range)),
        number("algorithm_1.weight_travel_per_rad", kPerRad, weight, "W1 of the deviation of the travel", FIELD(algorithm_1.weight_travel)),
        number("algorithm_1.weight_dead_band_per_rad", kPerRad, weight, "W2 of (final - initial dead-band): rewards a falling dead-band",
               FIELD(algorithm_1.weight_dead_band)),
        number("algorithm_1.weight_sensitivity_Nm_per_rad", kNmPerRad, weight, "W3 of the joint's sensitivity at peak torque",
               FIELD(algorithm_1.weight_sensitivity)),
    };
}

#undef FIELD

}  // namespace

std::vector<Key> design_keys() {
    std::vector<Key> all = search_keys();
    for (Key& key : algorithm_1_keys()) all.push_back(std::move(key));
    return all;
}

}  // namespace fusee::profile
