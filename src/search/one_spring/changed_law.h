#pragma once
#include <functional>
#include <vector>

#include "draft.h"

/// Laws near to a wanted one that no part can have (docs/guides/one-spring.md).
namespace fusee::search::one_spring {

/// The torques of a task at the points of a law through them, evenly over its travel [Nm].
[[nodiscard]] std::vector<double> points_of(const Task& task);
/// The profile with the law through these points.
[[nodiscard]] profile::Profile with_law(profile::Profile profile, const Task& task, const std::vector<double>& points);

/// The task of the law as the draft changes it: its beginning alone, under a Gaussian that keeps both ends, times a share.
[[nodiscard]] Task changed_task(const Task& task, const Draft& draft);

/// Root mean square over the angle of what lies between two laws [Nm]. @pre as many points
[[nodiscard]] double distance(const std::vector<double>& a, const std::vector<double>& b);

/// The points nearest to the wanted ones, by `distance`, for which `holds`, with the spring and the sizes of this part: sequential
/// quadratic programs over the curvature and the size of its contour and the pressure angle of its roller, each as far as `holds` allows.
/// The same on any number of threads. @pre the law of `part` is `with_law`, and it holds; two cables keep it
[[nodiscard]] std::vector<double> nearest_points(const profile::Profile& part, const std::vector<double>& wanted,
                                                 const std::function<bool(const std::vector<double>&)>& holds);

}  // namespace fusee::search::one_spring
