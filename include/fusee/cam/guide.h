#pragma once

namespace fusee::cam {

enum class GuideKind { kParallel, kPoint, kIdler };

/// The cable's direction or guide beyond the cam, in the world frame W (cam axis = +z through the origin).
struct Guide {
    GuideKind kind = GuideKind::kParallel;
    double direction =
        1.5707963267948966;  ///< kParallel: world direction from the cam along the cable [rad]; else direction of the guide's centre
    double distance = 0.0;   ///< kPoint, kIdler: axis to the guide's centre [m]; kParallel: to the hole that the cable goes to, 0 = not
                             ///< stated; the contour does not depend on it
    double radius = 0.0;     ///< kIdler: pitch radius [m]
    int sense = 1;           ///< kIdler: side on which the cable passes the idler's centre: +1 or -1 (see PART.json)
    double z = 0.0;          ///< height of the guide in the part's frame [m], used by a path aimed at the guide
};

}  // namespace fusee::cam
