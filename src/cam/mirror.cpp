#include "fusee/cam/mirror.h"

#include <utility>

#include "fusee/core/units.h"

namespace fusee::cam {

namespace {

core::Range mirrored(const core::Range& psi) { return {-psi.high, -psi.low}; }

PathPoint mirrored(const PathPoint& p) { return {-p.psi, p.h, -p.slope, p.rho, p.z}; }

ContourJet mirrored(ContourJet at) {
    at.psi = -at.psi;
    at.axial_slope = -at.axial_slope;  // dz/dpsi; d2z/dpsi2 and, by the piece's own parameter, rho stay
    return at;
}

std::vector<ContourPiece> mirrored(std::vector<ContourPiece> pieces) {
    for (ContourPiece& piece : pieces)
        piece.over = [over = std::move(piece.over)](const math::Interval& box) { return mirrored(over(box)); };
    return pieces;
}

}  // namespace

CamOptions mirrored(const CamOptions& options) {
    CamOptions other = options;
    other.torque_sign = -options.torque_sign;
    other.guide.direction = -options.guide.direction;
    other.roller.direction = -options.roller.direction;
    other.guide.sense = -options.guide.sense;
    other.roller.arm.side = -options.roller.arm.side;
    if (options.path.kind == PathKind::kHelix && options.path.lead == Lead::kConstantPitch)
        other.path.hand = options.path.hand == Hand::kRight ? Hand::kLeft : Hand::kRight;
    return other;
}

Cam mirrored(const Cam& cam) {
    Cam other = cam;
    other.options = mirrored(cam.options);
    other.rotation_sign = -cam.rotation_sign;
    for (Contact& row : other.working) row.path = mirrored(row.path);
    other.working_psi = mirrored(cam.working_psi);
    other.groove_psi = mirrored(cam.groove_psi);
    other.anchor_psi = -cam.anchor_psi;
    if (cam.closed()) {  // as synthesized: the turn starts with the working arc
        other.groove_psi = {other.working_psi.low, other.working_psi.low + core::kTurn};
        other.anchor_psi = core::within_turn(other.anchor_psi, other.groove_psi.low);
    }
    other.path = [path = cam.path](double psi) { return mirrored(path(-psi)); };
    if (cam.pieces) other.pieces = [pieces = cam.pieces] { return mirrored(pieces()); };
    return other;
}

Certificate mirrored(const Certificate& certificate, const Cam& image) {
    if (!certificate.open.empty()) return certify(image);
    Certificate other = certificate;
    other.working.psi = mirrored(other.working.psi);
    for (std::optional<LeastRadius>* radius : {&other.idle, &other.floor, &other.idle_floor})
        if (*radius) (*radius)->psi = mirrored((*radius)->psi);
    other.seam = seam(image);
    return other;
}

bool left_handed(const Cam& cam) { return !cam.closed() && cam.path(cam.groove_psi.high).z < cam.path(cam.groove_psi.low).z; }

}  // namespace fusee::cam
