#include <cmath>

#include "fusee/plant/rig.h"

namespace fusee::plant {

RigRange range_of(const Nominal& n) {
    const std::vector<double>& x = n.springs.deflection;
    const auto at = [&](const std::vector<double>& values, double where) { return torque_at(x, values, where); };
    const std::vector<double> se_energy = energy_of(x, n.springs.se), pe_energy = energy_of(x, n.springs.pe);
    RigRange range;
    range.nominal = &n;
    range.scale = n.top_torque / 1.5;
    range.travel = deflection_at(x, load_of(n.springs), n.top_torque);
    range.series = at(n.springs.se, range.travel);
    range.spool = std::sqrt(2.0 * at(se_energy, range.travel) / n.torsion_rate);
    range.stroke = std::sqrt(2.0 * at(pe_energy, range.travel) / n.compression_rate);
    const double half = 0.5 * range.travel;
    range.se_arm = std::sqrt(2.0 * n.torsion_rate * at(se_energy, half)) * n.capstan_radius / at(n.springs.se, half);
    range.pe_arm = at(n.springs.pe, range.travel) / (n.compression_rate * range.stroke);
    range.most_push = 0.93 * n.ratio() * n.springs.se.back();
    range.reach = deflection_at(x, n.springs.se, 0.5 * range.most_push / n.ratio()) / n.ratio();
    return range;
}

}  // namespace fusee::plant
