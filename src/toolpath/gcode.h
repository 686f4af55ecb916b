#pragma once
#include <fmt/format.h>

#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "fusee/solid/outline.h"
#include "fusee/solid/part.h"
#include "fusee/toolpath/settings.h"

namespace fusee::toolpath {

/// The text of a program: mm, mm/min and degrees to five decimals, finer than the resolution of any machine.
class Gcode {
public:
    explicit Gcode(const std::string& provenance) { comment("{}", provenance); }

    /// Brackets replace parentheses, which would end a comment.
    template <class... Args>
    void comment(fmt::format_string<Args...> format, Args&&... args) {
        std::string words = fmt::format(format, std::forward<Args>(args)...);
        for (char& c : words) c = c == '(' ? '[' : c == ')' ? ']' : c;
        line("({})", words);
    }
    template <class... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
        text_ += '\n';
    }
    /// Millimetres, absolute; the controller may round corners by `blend`.
    void begin(const Settings& settings);
    /// Changes to a tool with its length offset, after a comment with its sizes, and starts the spindle. `shape` is "end D" or
    /// "form NOSE HALF WIDTH" or "cone TIP LEAD D". The spindle goes to the machine's top before; X and Y come before Z afterwards.
    void tool(int number, const std::string& words, const std::string& shape, double flute_mm, double shank_mm, double rpm,
              const Settings& settings);
    void end();
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
};

[[nodiscard]] double mm_per_min(double feed);  ///< from m/s

inline constexpr double kWasher_mm = 2.0;     // of an arbor, beyond the bore's radius
inline constexpr double kClearance_mm = 1.0;  // above the stock: rapids go down to it, feeds go up to it

/// Feeds, depths and cutter in the program's own units.
struct Cutting {
    explicit Cutting(const Settings& settings);
    double cutter, feed, plunge, depth_per_pass, safe, breakthrough;  ///< [mm], [mm/min]; `safe` also above clamps that stand higher
    int tabs;
    double tab_width, tab_height;  ///< [mm]
};

/// The features of the part that no program cuts.
[[nodiscard]] std::string left_out(const solid::Part& part);

/// Up out of the stock by a feed, and on to the safe height.
void retract(Gcode& code, const Cutting& cutting);

/// Helical moves down to `depth` about (x, 0), the widest last, each with a level turn at its end.
void mill_bore(Gcode& code, const Cutting& cutting, double x, double radius, double depth);

/// One turn around a convex ring at a depth, clockwise with the cutter on its left (climb milling), with tangential arcs in and out.
/// @param over_tabs less depth where tabs remain, evenly along the ring; not below `depth`: no tabs
void mill_ring(Gcode& code, const Cutting& cutting, const std::vector<solid::Arc>& ring, double depth, double over_tabs);

/// Extent of a ring's lead-in beyond it [mm].
[[nodiscard]] double lead_length(double cutter);

/// A point of a convex outline whose outward normal has the direction psi [mm].
using ConvexOutline = std::function<solid::Point2(double psi)>;

/// Arcs that follow a closed convex outline counter-clockwise, each `begin` to `end` in psi, joined without a corner. Between two normals a
/// pair of arcs has both end points and both end tangents (docs/theory/toolpaths.md, eq. 1). No arc is farther from the outline than
/// `tolerance_mm`. This is measured by the support functions: for convex curves their largest difference is the largest distance.
/// @param start psi at the start of the ring and, one turn later, at its end
/// @pre the outline's radius of curvature is above 0
[[nodiscard]] std::vector<solid::Arc> fit_arcs(const ConvexOutline& outline, double start, double tolerance_mm);

/// The parallel ring at a distance outside (above 0) or inside. @pre every radius stays above 0
[[nodiscard]] std::vector<solid::Arc> parallel(std::vector<solid::Arc> ring, double offset_mm);

/// The ring from below: turned over about the x axis, still counter-clockwise, with the same start.
[[nodiscard]] std::vector<solid::Arc> turned_over(const std::vector<solid::Arc>& ring);

}  // namespace fusee::toolpath
