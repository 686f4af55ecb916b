#include <cmath>

#include "fusee/spring/coil.h"
#include "layout.h"

namespace fusee::assembly {

namespace {

using Eigen::Vector3d;

constexpr int kCableEnds = 16;  // of the spool, between which its cable lies
constexpr double kStep = core::kPi / 180.0;

/// The series cable on the carriage, about K_SE's axis at rest: from places along the cam to the guide.
std::vector<Vector3d> cable_ends(const Layout& l, const cam::Cam& cam) {
    std::vector<Vector3d> all;
    for (int i = 0; i <= kCableEnds; ++i) {
        const cam::Contact& contact = cam.working[(cam.working.size() - 1) * static_cast<std::size_t>(i) / kCableEnds];
        const Vector3d on_part(1e3 * contact.path.x(), 1e3 * contact.path.y(), 1e3 * contact.path.z);
        const double turned = cam.rotation_sign * (contact.arm.angle - cam.working.front().arm.angle);
        all.push_back(l.k_se * (Eigen::AngleAxisd(turned, Vector3d::UnitZ()) * on_part) - l.spool_axis);
    }
    return all;
}

std::vector<Prism> posts_at(const Layout& l, const Drive& drive, double angle) {
    std::vector<Prism> all;
    for (Extrusion& shape : leg_posts(l, drive)) {
        turn_about_axis(shape, angle);
        all.push_back(prism_of(shape, Eigen::Isometry3d::Identity()));
    }
    return all;
}

/// Do the posts keep off the series cable, and behind its guide?
bool is_free(const Layout& l, const Drive& drive, const std::vector<Vector3d>& ends, double angle) {
    const double space = 0.5 * l.cable + l.gap;
    const Vector3d guide = l.k_se_guide - l.spool_axis;
    for (const Prism& prism : posts_at(l, drive, angle)) {
        for (const Vector3d& end : ends)
            if (distance_mm(end, guide, prism, space) < space) return false;
        for (const solid::Point2& p : prism.outline_mm)
            if (p[1] > l.guide_distance - l.idler - l.gap) return false;
    }
    return true;
}

}  // namespace

void turn_about_axis(Extrusion& shape, double angle) { shape.frame = Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * shape.frame; }

std::vector<Extrusion> leg_posts(const Layout& l, const Drive& drive) {
    const LegSlot& slot = l.leg_slot;
    const double side = 0.5 * slot.width_mm + kProng_mm, foot = slot.width_mm > 0.0 ? slot.floor_mm : slot.top_mm;
    std::vector<Extrusion> all{box({l.leg_post - kLegPost_mm, -side, l.base_high}, {l.leg_post + kLegPost_mm, side, foot})};
    if (!has_bridge(drive)) return all;
    const double half = 0.5 * arbor_mm(drive) + 1.0, column = leg_end_mm(l.leg_post, drive.k_se_spring) + l.gap;
    all.push_back(box({column, -half, l.base_high}, {column + l.wall, half, slot.top_mm + l.gap}));
    return all;
}

// The coils are wound by the part that turns their lower end with its rotation: they rise against it.
std::optional<double> leg_angle(const Drive& drive, const Eigen::Isometry3d& k_se) {
    const spring::BaseSpring& s = drive.k_se_spring;
    const solid::FeatureOptions& slot = drive.k_se->options.features;
    if (slot.leg_slot_width <= 0.0 || outer_mm(s) <= 0.0 || s.active_coils <= 0.0) return std::nullopt;
    const double axial = std::atan2(k_se.linear()(1, 0), k_se.linear()(0, 0)) + slot.leg_slot_angle;
    return axial - drive.k_se->cam.rotation_sign * spring::leg_turn(s, s.preload);
}

double post_angle(const Layout& l, const Drive& drive) {
    const double wanted = leg_angle(drive, l.k_se).value_or(core::kPi);
    const std::vector<Vector3d> ends = cable_ends(l, drive.k_se->cam);
    for (double aside = 0.0; aside < core::kPi; aside += kStep)
        for (const double angle : {wanted - aside, wanted + aside})
            if (is_free(l, drive, ends, angle)) return std::remainder(angle, 2.0 * core::kPi);
    return core::kPi;
}

double post_rear_mm(const Layout& l, const Drive& drive) {
    double rear = 0.0;
    for (const Prism& prism : posts_at(l, drive, l.leg_post_angle))
        for (const solid::Point2& p : prism.outline_mm) rear = std::max(rear, -p[1]);
    return rear;
}

}  // namespace fusee::assembly
