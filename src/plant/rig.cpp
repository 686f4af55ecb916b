#include "fusee/plant/rig.h"

#include <algorithm>

#include "fusee/core/units.h"

namespace fusee::plant {

namespace {

constexpr std::size_t kLeadRows = 400, kLawRows = 3600;

void append(SpringCurves& springs, double deflection, double se, double pe) {
    springs.deflection.push_back(deflection);
    springs.se.push_back(se);
    springs.pe.push_back(pe);
}

/// (k, u, C) with k = 1; a k of its own only scales the deflections, by 1/k.
struct StictionLaw {
    double mu, u, c, start;
    [[nodiscard]] double share(double load) const { return u * u / (mu * load * load) + c / load; }  // T = S/(S + P)
    [[nodiscard]] double deflection(double load) const {
        return u * u / (3.0 * mu) * (std::pow(start, -3) - std::pow(load, -3)) + 0.5 * c * (std::pow(start, -2) - std::pow(load, -2));
    }
    [[nodiscard]] double se(double load) const {
        return share(start) * start + c * std::log(load / start) + u * u / mu * (1.0 / start - 1.0 / load);
    }
};

/// Begins each spring with a parabola from the origin that meets the law with its slope: both have the same F/F' at the start, T load/S.
SpringCurves stiction_springs(double mu, double top_load, Random& random) {
    StictionLaw law{mu, random.uniform(0.0, 0.06), random.uniform(0.3, 0.46), 0.0};
    const double least = 0.5 * (law.c + std::sqrt(law.c * law.c + 4.0 * law.u * law.u / mu));  // T = 1
    law.start = random.uniform(1.15, 1.4) * least;
    const double bow = random.uniform(1.2, 1.8);  // 1: straight lead, 2: level at the origin
    const double share = law.share(law.start), lead = bow * share / law.start;
    SpringCurves springs;
    for (std::size_t i = 0; i < kLeadRows; ++i) {
        const double s = static_cast<double>(i) / static_cast<double>(kLeadRows);
        const double load = law.start * ((2.0 - bow) * s + (bow - 1.0) * s * s);
        append(springs, lead * s, share * load, (1.0 - share) * load);
    }
    for (std::size_t i = 0; i <= kLawRows; ++i) {
        const double load = law.start * std::pow(top_load / law.start, static_cast<double>(i) / static_cast<double>(kLawRows));
        append(springs, lead + law.deflection(load), law.se(load), load - law.se(load));
    }
    const double travel = random.uniform(3.2, 4.8) / springs.deflection.back();
    for (double& x : springs.deflection) x *= travel;
    return springs;
}

/// Both springs stiffen with the deflection, but for linear ones; the parts that they bear at the end, and how late they rise, are drawn.
SpringCurves stiffening_springs(LawKind kind, double top_load, Random& random) {
    const double travel = random.uniform(3.2, 4.5), series = top_load * random.uniform(0.45, 0.6);
    const double se_bend = random.uniform(1.5, 2.8), pe_bend = random.uniform(2.0, 3.5);
    const auto rise = [&](double s, double bend) {
        if (kind == LawKind::kLinear) return s;
        return kind == LawKind::kExponential ? std::expm1(bend * s) / std::expm1(bend) : (s + bend * s * s * s) / (1.0 + bend);
    };
    SpringCurves springs;
    for (std::size_t i = 0; i <= kLawRows; ++i) {
        const double s = static_cast<double>(i) / static_cast<double>(kLawRows);
        append(springs, travel * s, series * rise(s, se_bend), (top_load - series) * rise(s, pe_bend));
    }
    return springs;
}

SideTruth build_side(const Nominal& n, const Tolerance& t, Random& random) {
    SideTruth side;
    side.capstan_radius = n.capstan_radius * (1.0 + t.radii * random.normal());
    side.joint_radius = n.joint_radius * (1.0 + t.radii * random.normal());
    side.mu = n.mu * (1.0 + t.mu * random.normal());
    side.viscous = n.motor_viscous;
    side.inertia = n.motor_inertia * (1.0 + t.inertia * random.normal());
    side.torque_scale = 1.0 + t.torque_scale * random.normal();
    side.se.rate = n.torsion_rate * (1.0 + t.spring_rate * random.normal());
    side.se.radius_offset = t.se_radius * random.normal();
    side.se.preload = t.se_preload * random.normal();
    side.pe.rate = n.compression_rate * (1.0 + t.spring_rate * random.normal());
    side.pe.radius_offset = t.pe_radius * random.normal();
    side.pe.preload = t.pe_preload * random.normal();
    return side;
}

constexpr std::uint64_t kGolden = 0x9e3779b97f4a7c15ULL;

std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

}  // namespace

SpringCurves draw_springs(LawKind kind, double mu, double top_load, Random& random) {
    if (kind == LawKind::kStictionCompensating) return stiction_springs(mu, top_load, random);
    return stiffening_springs(kind, top_load, random);
}

Nominal draw_nominal(Random& random, bool linear_springs) {
    constexpr double kReserve = 1.5;  // of the springs' range over the load that the gear can hold back
    Nominal n;
    n.mu = random.uniform(0.15, 0.4);
    do {
        n.capstan_radius = 1e-4 * std::round(1e4 * random.uniform(0.012, 0.020));
        n.joint_radius = 1e-4 * std::round(1e4 * random.uniform(0.016, 0.028));
    } while (n.ratio() < 1.0 || n.ratio() > 1.8);
    n.mu = 1e-3 * std::round(1e3 * n.mu);
    n.motor_inertia = 1e-5 * std::round(1e5 * random.uniform(0.0015, 0.0025));
    n.joint_inertia = 1e-5 * std::round(1e5 * random.uniform(0.005, 0.008));
    n.motor_viscous = 1e-5 * std::round(1e5 * random.uniform(0.003, 0.005));
    n.joint_viscous = 1e-5 * std::round(1e5 * random.uniform(0.0015, 0.003));
    const double pick = random.uniform(0.0, 1.0);
    const LawKind kind = linear_springs ? LawKind::kLinear
                         : pick < 0.4   ? LawKind::kStictionCompensating
                         : pick < 0.7   ? LawKind::kExponential
                                        : LawKind::kCubic;
    // The law's K_SE bears little at high loads: a push could not overcome the gears there.
    const double top = kind == LawKind::kStictionCompensating ? random.uniform(0.75, 1.1) : random.uniform(1.2, 1.6);
    n.top_torque = 0.05 * std::round(20.0 * top);
    n.springs = draw_springs(kind, n.mu, kReserve * n.top_torque / (1.0 - n.mu), random);
    const double spool = random.uniform(2.0, 3.2), stroke = random.uniform(0.028, 0.042);
    n.torsion_rate = 2.0 * energy_of(n.springs.deflection, n.springs.se).back() / (spool * spool);
    n.compression_rate = 2.0 * energy_of(n.springs.deflection, n.springs.pe).back() / (stroke * stroke);
    return n;
}

Truth build(const Nominal& nominal, const Tolerance& tolerance, Random& random) {
    Truth truth;
    for (SideTruth& side : truth.sides) side = build_side(nominal, tolerance, random);
    truth.joint.inertia = nominal.joint_inertia * (1.0 + tolerance.inertia * random.normal());
    truth.joint.viscous = nominal.joint_viscous;
    truth.joint.coulomb = tolerance.joint_coulomb * std::abs(random.normal());
    truth.joint.encoder_offset = tolerance.joint_offset * random.normal();
    truth.presliding = random.uniform(0.0, 1.0) < 0.5 ? Presliding::kElastoPlastic : Presliding::kLuGre;
    truth.bristle = random.uniform(1000.0, 2500.0);
    truth.hand = random.uniform(0.9, 1.2);
    return truth;
}

double torque_at(const std::vector<double>& deflection, const std::vector<double>& torque, double x) {
    const auto above = std::upper_bound(deflection.begin() + 1, deflection.end() - 1, x);
    const auto i = static_cast<std::size_t>(above - deflection.begin());
    return torque[i - 1] + (torque[i] - torque[i - 1]) * (x - deflection[i - 1]) / (deflection[i] - deflection[i - 1]);
}

double deflection_at(const std::vector<double>& deflection, const std::vector<double>& torque, double wanted) {
    return wanted >= torque.back() ? deflection.back() : torque_at(torque, deflection, wanted);
}

std::vector<double> load_of(const SpringCurves& springs) {
    std::vector<double> load(springs.se);
    for (std::size_t i = 0; i < load.size(); ++i) load[i] += springs.pe[i];
    return load;
}

std::vector<double> energy_of(const std::vector<double>& deflection, const std::vector<double>& torque) {
    std::vector<double> energy(deflection.size(), 0.0);
    for (std::size_t i = 1; i < energy.size(); ++i)
        energy[i] = energy[i - 1] + 0.5 * (torque[i] + torque[i - 1]) * (deflection[i] - deflection[i - 1]);
    return energy;
}

Random::Random(std::uint64_t seed, std::uint64_t index, std::uint64_t purpose)
    : key_(mixed(mixed(mixed(seed + kGolden) + index * kGolden + 1) + purpose * kGolden + 2)) {}

std::uint64_t Random::bits() { return mixed(key_ + ++counter_ * kGolden); }

double Random::uniform(double low, double high) {
    constexpr double kStep = 0x1.0p-53;
    return low + (high - low) * (static_cast<double>(bits() >> 11) + 0.5) * kStep;
}

double Random::normal() {
    const double radius = std::sqrt(-2.0 * std::log(uniform(0.0, 1.0)));
    return radius * std::cos(2.0 * core::kPi * uniform(0.0, 1.0));
}

double Random::either_sign(double magnitude) { return (bits() >> 63) != 0 ? magnitude : -magnitude; }

std::uint64_t Random::below(std::uint64_t end) { return bits() % end; }

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
