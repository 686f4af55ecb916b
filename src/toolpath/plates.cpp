#include "plates.h"

#include <algorithm>
#include <cmath>

#include "fusee/core/units.h"
#include "fusee/solid/sweep.h"
#include "gcode.h"

namespace fusee::toolpath {

namespace {

using core::kTurn;
using core::mm_from_m;

/// Depth of the drawn groove at a height above its plane: offset from the pitch curve [mm].
double groove_offset(const std::vector<solid::SectionPoint>& section, double height) {
    if (height <= 0.0) return section[section.size() / 2].offset_mm;  // the floor's lowest point is a vertex, in the middle
    const auto above =
        std::lower_bound(section.begin(), section.end(), height, [](const solid::SectionPoint& p, double z) { return p.z_mm < z; });
    if (above == section.end()) return section.back().offset_mm;
    const auto below = std::prev(above);
    return below->offset_mm + (above->offset_mm - below->offset_mm) * (height - below->z_mm) / (above->z_mm - below->z_mm);
}

/// Rings of a planar part.
class Rings {
public:
    Rings(const solid::Part& part, const Settings& settings)
        : part_(part), flanges_(solid::flanges_of(part.options)), tolerance_(mm_from_m(settings.tolerance)), pitch_(fit(0.0, 0.0)) {}

    /// Parallel of the pitch curve.
    [[nodiscard]] std::vector<solid::Arc> at(double offset) const { return parallel(pitch_, offset); }
    [[nodiscard]] std::vector<solid::Arc> lower_flange() const {
        const double offset = lip() + flanges_.lower_height_mm;
        return flanges_.core_radius_mm > 0.0 ? fit(offset, flanges_.core_radius_mm) : at(offset);
    }
    [[nodiscard]] std::vector<solid::Arc> upper_flange() const { return at(lip() + flanges_.upper_height_mm); }
    [[nodiscard]] double lip() const { return part_.section.front().offset_mm; }
    [[nodiscard]] double lip_height() const { return part_.section.back().z_mm; }

private:
    /// Starts in the middle of the idle arc, where no cable runs over a mark of the cutter's entry and exit.
    [[nodiscard]] std::vector<solid::Arc> fit(double offset, double core_radius) const {
        const core::Range turn = part_.cam.groove_psi, working = part_.cam.working_psi;
        const auto outline = [&](double psi) {
            return solid::flange_point(part_.cam.path(core::within_turn(psi, turn.low)), offset, core_radius).point;
        };
        return fit_arcs(outline, 0.5 * (working.high + working.low + kTurn), tolerance_);
    }

    const solid::Part& part_;
    solid::Flanges flanges_;
    double tolerance_;
    std::vector<solid::Arc> pitch_;
};

void add_bore(Plate& plate, const solid::Part& part, double depth) {
    const solid::HubOptions& hub = part.options.hub;
    plate.bore_radius = 0.5 * mm_from_m(hub.bore_diameter + hub.bore_clearance);
    plate.bore_depth = depth;
}

std::vector<Wall> terraces(const Rings& rings, const std::vector<solid::SectionPoint>& section, double step) {
    const int count = std::max(1, static_cast<int>(std::ceil(rings.lip_height() / step)));
    std::vector<Wall> walls;
    walls.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        walls.push_back({rings.at(groove_offset(section, rings.lip_height() * i / count)), rings.lip_height() * (i + 1) / count});
    return walls;
}

}  // namespace

std::vector<Plate> half_plates(const solid::Part& part, const Settings& settings) {
    const Rings rings(part, settings);
    Plate lower{"lower", false, terraces(rings, part.section, mm_from_m(settings.terrace)), mm_from_m(-part.z_low), 0.0, 0.0};
    Plate upper{"upper", true, lower.walls, mm_from_m(part.z_high), 0.0, 0.0};
    lower.walls.push_back({rings.lower_flange(), lower.thickness});
    upper.walls.push_back({rings.upper_flange(), upper.thickness});
    for (Wall& wall : upper.walls) wall.ring = turned_over(wall.ring);
    if (part.options.hub.kind == solid::HubKind::kThrough)
        for (Plate* plate : {&lower, &upper}) add_bore(*plate, part, plate->thickness);
    return {lower, upper};
}

Plate blank_plate(const solid::Part& part, const Settings& settings) {
    const Rings rings(part, settings);
    Plate plate{"blank", false, {}, mm_from_m(part.z_high - part.z_low), 0.0, 0.0};
    plate.walls = {{rings.upper_flange(), mm_from_m(part.z_high) + rings.lip_height()}, {rings.lower_flange(), plate.thickness}};
    if (part.options.hub.kind == solid::HubKind::kThrough) add_bore(plate, part, plate.thickness);
    return plate;
}

Plate boss_plate(const solid::Part& part, const Settings& settings) {
    const solid::HubOptions& hub = part.options.hub;
    const double radius = 0.5 * mm_from_m(hub.boss_diameter), height = mm_from_m(hub.boss_height);
    Plate plate{"boss", true, {}, height, 0.0, 0.0};
    const auto circle = [radius](double psi) { return solid::Point2{radius * std::cos(psi), radius * std::sin(psi)}; };
    plate.walls = {{fit_arcs(circle, 0.0, mm_from_m(settings.tolerance)), height}};
    const bool through = hub.kind == solid::HubKind::kThrough;
    // A blind bore ends `web` below the groove, which may be within the lower flange: then it passes through the boss.
    const double above = mm_from_m(hub.web - part.options.groove.rib);
    add_bore(plate, part, through ? height : std::min(height, height - above));
    return plate;
}

}  // namespace fusee::toolpath
