#include <algorithm>
#include <cmath>

#include "enclosure.h"
#include "fusee/cam/arm.h"
#include "path.h"
#include "scan.h"

namespace fusee::cam {

namespace {

constexpr int kRounds = 2;  // a round divides the error by about 1/(1 - cos(fleet)), above 400 at 4 degrees

double at(const math::ChebyshevSeries& series, double angle) { return series(angle); }
math::Jet at(const math::ChebyshevSeries& series, const math::Jet& angle) {
    const math::Jet over = series.over(angle.value);
    return {over.value, over.slope * angle.slope};
}

}  // namespace

FleetAngleCorrection::FleetAngleCorrection(double last, const Shares& shares)
    : share_({0.0, last}, shares), first_(share_.derivative()), second_(first_.derivative()) {}

template <class Arm>
void FleetAngleCorrection::project(Arm& a) const {
    const auto share = at(share_, a.angle), first = at(first_, a.angle), second = at(second_, a.angle);
    a.arm /= share;  // r = share * h, and its two derivatives
    a.slope = (a.slope - a.arm * first) / share;
    a.second_derivative = (a.second_derivative - 2.0 * a.slope * first - a.arm * second) / share;
}
template void FleetAngleCorrection::project(ArmPoint&) const;
template void FleetAngleCorrection::project(ArmJet&) const;

double fleet_of(const Contact& contact, const Guide& guide) {
    return guide.kind == GuideKind::kParallel ? 0.0 : std::atan2(guide.z - contact.path.z, contact.span);
}

std::optional<ArmFunction> in_plane(const ArmFunction& arm, const CamOptions& options, std::vector<Contact> contacts) {
    if (options.family == Family::kRoller || options.guide.kind == GuideKind::kParallel) return std::nullopt;
    const FleetAngleCorrection::Shares places = FleetAngleCorrection::places(contacts.back().arm.angle);
    ArmFunction flat = arm;
    for (int round = 0; round < kRounds; ++round) {
        if (round > 0) contacts = scan_contacts(flat, options, contacts.size());
        const Height height(options, contacts);
        FleetAngleCorrection::Shares shares{};
        for (std::size_t i = 0; i < places.size(); ++i) {
            Contact contact = contact_at(flat, options, contacts, places[i]);
            contact.path.z = height.at(contact.path.psi);
            shares[i] = std::cos(fleet_of(contact, options.guide));
        }
        if (std::all_of(shares.begin(), shares.end(), [](double share) { return share == 1.0; })) return std::nullopt;
        flat = arm.corrected_for_fleet_angle({places.back(), shares});
    }
    return flat;
}

}  // namespace fusee::cam
