#include "transform.h"

#include <gp_Trsf.hxx>

namespace fusee::exchange::brep {

gp_Trsf transform_of(const Eigen::Isometry3d& placement) {
    const Eigen::Matrix4d& m = placement.matrix();
    gp_Trsf to;
    to.SetValues(m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1), m(1, 2), m(1, 3), m(2, 0), m(2, 1), m(2, 2), m(2, 3));
    return to;
}

}  // namespace fusee::exchange::brep
