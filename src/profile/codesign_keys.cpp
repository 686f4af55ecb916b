#include "key.h"

namespace fusee::profile {

namespace {

#define OF(member) \
    [](auto& p) -> auto& { return p.co_design.member; }

std::vector<Key> wishes() {
    const Limits torque = within(0, 1e4);
    return {
        choice("co_design.law", {"stiction_compensating", "free_curve"}, "law that is searched together with springs, radius and lead-in",
               OF(law)),
        when("co_design.law", {"free_curve"},
             integer("co_design.knots", within(4, 12), "of the free curve, evenly spaced in ln(load)", OF(knots))),
        choice("co_design.figure", {"mean", "worst", "percentile_95"},
               "of the exact dead-bands at co_design.torques_Nm; percentile_95: the mean of the 95th percentiles over the shop's scatter",
               OF(figure)),
        numbers("co_design.torques_Nm", torque, 0, 40, "co-contraction at which the dead-band counts; none: 6 from least to overdrive",
                OF(torques)),
        range("co_design.loads_Nm", torque, "travel is demanded between these loads, stiffness at them; 0, 0: least to overdrive",
              OF(loads)),
        number("co_design.travel_rad", within(0, 100), "least capstan travel between them; 0: that of the profile's law", OF(travel)),
        number("co_design.soft_Nm_per_rad", within(0, 1e6),
               "largest joint stiffness, capstans held, at the lower load; 0: that of the profile's law", OF(soft)),
        number("co_design.stiff_Nm_per_rad", within(0, 1e6), "least joint stiffness at the upper load; 0: that of the profile's law",
               OF(stiff)),
        choice("co_design.against", {"travel", "size"}, "second objective of a Pareto front", OF(against)),
    };
}

/// Only the objective over a shop's scatter uses it.
Key of_scatter(Key key) { return when("co_design.figure", {"percentile_95"}, std::move(key)); }

std::vector<Key> scatter() {
    const Limits share = within(0, 0.3);
    return {
        of_scatter(number("co_design.scatter_rate_se", share,
                          "of K_SE's base springs, one standard deviation over the rate: a stated +-10 % is two of them",
                          OF(scatter.rate_se))),
        of_scatter(number("co_design.scatter_rate_pe", share, "of K_PE's base springs", OF(scatter.rate_pe))),
        of_scatter(
            number("co_design.scatter_contour_mm", within(0, 10), "excess of a cam's arms, one standard deviation", OF(scatter.contour))),
        of_scatter(number("co_design.scatter_friction", share,
                          "of each gear, one standard deviation over its friction: +-20 % is two of them", OF(scatter.friction))),
        of_scatter(number("co_design.covered_share", within(0, 1),
                          "least share of built joints whose springs reach both edges, at each of co_design.torques_Nm; 0: no demand",
                          OF(covered_share))),
    };
}

std::vector<Key> limits() {
    return {
        number("co_design.contour_radius_mm", above(0, 1000), "greatest, of both cams' working arcs; idle arcs extend a few mm further",
               OF(contour_radius)),
        number("co_design.least_rho_se_mm", within(0, 1000), "least radius of curvature of K_SE's working arc", OF(least_rho_se)),
        number("co_design.least_rho_pe_mm", within(0, 1000), "least radius of curvature of K_PE's working arc", OF(least_rho_pe)),
        choice("co_design.reviews", {"avoid", "accept"}, "whether the search avoids warnings of the rules (review and accept)",
               OF(reviews)),
        range("co_design.capstan_radius_mm", within(0, 1000), "r_c searched; 0, 0: the profile's. r_j/r_c stays", OF(capstan_radius)),
        range("co_design.lead_in_deg", within(0, 720), "lead-in searched", OF(lead_in)),
        range("co_design.winding_rad", within(0, 1e3), "preload of the torsion spring searched", OF(winding)),
        range("co_design.compression_mm", within(0, 1e3), "preload of the compression spring searched", OF(compression)),
        number("co_design.span", above(1, 1e3), "rates and k are searched from 1/span to span times the profile's", OF(span)),
        file("co_design.catalogue", "CSV of springs in the profile's folder, from which both are chosen; missing: any rate",
             OF(catalogue_file)),
    };
}

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
        range("algorithm_1.k_per_Nm_rad", above(0, 1e6), "box of k: lowest, highest", FIELD(algorithm_1.k)),
        range("algorithm_1.u_Nm", within(-1e3, 1e3), "box of u; u and -u are the same springs", FIELD(algorithm_1.u)),
        range("algorithm_1.c_Nm", within(-1e3, 1e3), "box of C", FIELD(algorithm_1.c)),
        integer("algorithm_1.torques", within(2, 100000), "levels of the co-contraction, from law.start_torque_Nm to rig.peak_torque_Nm",
                FIELD(algorithm_1.torques)),
        number("algorithm_1.wanted_travel_deg", within(0, 36000), "wanted capstan angle between them; 0: that of the profile's law",
               FIELD(algorithm_1.wanted_travel)),
        number("algorithm_1.joint_range_deg", above(0, 36000), "range of the joint, the greatest dead-band",
               FIELD(algorithm_1.joint_range)),
        number("algorithm_1.weight_travel_per_rad", weight, "W1 of the deviation of the travel", FIELD(algorithm_1.weight_travel)),
        number("algorithm_1.weight_dead_band_per_rad", weight, "W2 of (final - initial dead-band): rewards a falling dead-band",
               FIELD(algorithm_1.weight_dead_band)),
        number("algorithm_1.weight_sensitivity_Nm_per_rad", weight, "W3 of the joint's sensitivity at peak torque",
               FIELD(algorithm_1.weight_sensitivity)),
    };
}

}  // namespace

std::vector<Key> codesign_keys() { return core::joined(wishes(), scatter(), limits()); }

#undef OF

std::vector<Key> design_keys() { return core::joined(search_keys(), algorithm_1_keys()); }

}  // namespace fusee::profile
