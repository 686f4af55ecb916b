#include "two_cables.h"

#include <cmath>

#include "fusee/cam/mirror.h"

namespace fusee::pipeline {

std::array<profile::Profile, 2> each_way(const profile::Profile& both, double travel) {
    using Way = profile::OneSpring::TwoCables::Way;
    std::array<profile::Profile, 2> ways{both, both};
    const auto set = [](profile::Profile& p, Way way) { std::get<profile::OneSpring>(p.law.curves).two_cables.way = way; };
    set(ways[0], Way::kForth);
    set(ways[1], Way::kBack);
    const auto& two = std::get<profile::OneSpring>(both.law.curves).two_cables;
    profile::PartSpec& back = ways[1].k_pe;
    if (two.back_preload > 0.0) back.spring.preload = two.back_preload;
    const double direction = back.cam.guide.direction + two.back_turned + back.cam.torque_sign * travel;
    back.cam = cam::mirrored(back.cam);
    back.cam.guide.direction = std::remainder(direction, core::kTurn);
    return ways;
}

}  // namespace fusee::pipeline
