#pragma once
#include <string>

/// Scripts that pages carry, from web/built (web/README.md). Each is one `<style>` and one `<script>` element.
namespace fusee::report {

/// The charts' library: `fusee.plot` is uPlot.
[[nodiscard]] std::string plot_bundle();
/// The joint in 3D; it needs `plot_bundle` before it.
[[nodiscard]] std::string joint_bundle();

}  // namespace fusee::report
