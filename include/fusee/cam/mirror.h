#pragma once
#include "fusee/cam/cam.h"
#include "fusee/cam/certificate.h"

/// Mirror images in the plane of the cam's axis and its timing mark, y -> -y (docs/theory/cams.md). The agonist's part and the antagonist's
/// are mirror images of each other: same arms at the same cam angles, every sense of rotation reversed.
namespace fusee::cam {

/// Torque sign, direction of the guide or follower and side of the idler change; a helix of constant pitch gets the other hand. An aimed
/// helix still leads to its guide, whose height stays.
[[nodiscard]] CamOptions mirrored(const CamOptions& options);

/// psi -> -psi: h, rho, z, span and fleet angle stay, h' and dz/dpsi change their signs; the cam turns in the opposite sense.
/// mirrored(synthesize_cam(arm, options)) is synthesize_cam(arm, mirrored(options)), and mirroring twice changes nothing.
[[nodiscard]] Cam mirrored(const Cam& cam);

/// The certificate of the mirror image: the same bounds at the mirrored places. Its seam lies at the other end of the working arc and is
/// measured; a certificate with unproven claims, which names their places in words, is made anew.
[[nodiscard]] Certificate mirrored(const Certificate& certificate, const Cam& image);

/// Does the height fall as psi rises? A helix that rises is right-handed, like a common screw; planar: false.
[[nodiscard]] bool left_handed(const Cam& cam);

}  // namespace fusee::cam
