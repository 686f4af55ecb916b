#include "scan.h"

#include <algorithm>

#include "fusee/cam/contact.h"

namespace fusee::cam {

std::vector<Contact> scan_contacts(const ArmFunction& arm, const CamOptions& options, std::size_t count) {
    std::vector<Contact> contacts;
    const core::Range loads = arm.law().loads();
    for (std::size_t i = 0; i < count; ++i)
        contacts.push_back(
            touch(arm.kind(), arm.at_load(loads.low + loads.width() * static_cast<double>(i) / static_cast<double>(count - 1)), options));
    return contacts;
}

Contact contact_at(const ArmFunction& arm, const CamOptions& options, const std::vector<Contact>& scanned, double angle) {
    const auto after =
        std::upper_bound(scanned.begin() + 1, scanned.end() - 1, angle, [](double v, const Contact& c) { return v < c.arm.angle; });
    const double tau = solve_between([&](double t) { return arm.at_load(t).angle - angle; }, (after - 1)->arm.tau, after->arm.tau);
    return touch(arm.kind(), arm.at_load(tau), options);
}

}  // namespace fusee::cam
