#pragma once
#include "fusee/core/finding.h"

namespace fusee::toolpath {

/// The controller of the machine.
enum class Controller { kLinuxCnc };

/// The method for the groove of a part.
enum class Method {
    kStack,  ///< two plates that meet in the groove's plane, each cut from that face on three axes; planar parts only
    kWrap,   ///< one piece, its blank on three axes, its groove on a rotary axis
};

/// What is cut, for speeds and feeds.
enum class Stuff { kPlastic, kAluminium, kBrass, kSteel };

/// A workshop's machine. The groove gives the cutter of a wrap; all other cuts use the flat end mill.
struct Settings {
    Controller controller = Controller::kLinuxCnc;
    Method k_se = Method::kStack;
    Method k_pe = Method::kWrap;       ///< a helix is always wrapped
    double tool_diameter = 3e-3;       ///< flat end mill [m]
    double feed = 0.0;                 ///< of the tool's tip along the part [m/s]; 0: by chip load (`feed_of`)
    double plunge_feed = 0.0;          ///< straight down and down a helix [m/s]; 0: a third of the feed
    double spindle_rpm = 12000.0;      ///< clockwise [1/min]
    double depth_per_pass = 0.5e-3;    ///< [m]
    double terrace = 0.1e-3;           ///< height of the terraces of a plate's half groove [m]
    double wrap_feed = 0.0;            ///< of the groove's cutter along the part [m/s]; 0: by chip load
    double wrap_rpm = 20000.0;         ///< [1/min]
    double wrap_depth = 0.1e-3;        ///< of one pass of the groove's cutter [m]
    double safe_height = 5e-3;         ///< above the stock's top: rapids stay there [m]
    double breakthrough = 0.3e-3;      ///< below the stock's bottom, into the board below it [m]
    double tolerance = 1e-6;           ///< largest distance between the contour and the arcs and lines of a program [m]
    Stuff stuff = Stuff::kPlastic;     ///< not a key: by the process's material
    double blend = 2e-6;               ///< G64: the controller may round corners by this [m]; not a key: the chordal error
    double spindle_max_rpm = 24000.0;  ///< of the machine [1/min]
    int flutes = 2;                    ///< teeth of each cutter
    double flute_length = 9e-3;        ///< of the end mill [m]
    double stick_out = 25e-3;          ///< of every cutter below its holder [m]
    double holder_diameter = 19e-3;    ///< nut of an ER11 collet [m]
    double chuck_diameter = 42e-3;     ///< of the rotary axis: nut of an ER25 collet chuck [m]
    double chuck_grip = 8e-3;          ///< length of the boss inside it [m]
    double dowel_diameter = 2e-3;      ///< of the two pins that register half plates [m]; 0: none
    int tabs = 3;                      ///< that hold a plate in its sheet; 0: none
    double tab_width = 4e-3;           ///< [m]
    double tab_height = 0.5e-3;        ///< [m]
    int rotary_sign = 1;               ///< 1: a positive A turns the part by the right-hand rule about +X; -1: the other way (ISO 841)
};

/// @throws InvalidInput naming the key of `[machining]` that is not positive or, rotary_sign, neither 1 nor -1
void require_valid(const Settings& settings);

/// "aluminium"
[[nodiscard]] const char* to_string(Stuff stuff);
/// Chip load of a carbide cutter [mm per tooth], in proportion to its diameter: aluminium 0.025 and steel 0.013 at 3 mm
/// (machinecalcs.com), plastic 0.036 (fmcarbide.com, 0.03 to 0.06), brass 0.022 (formulafactory.tools, 0.020 to 0.038).
[[nodiscard]] double chip_load_mm(Stuff stuff, double diameter_mm);
/// The feed asked for, or if that is 0 the one of the chip load [m/s].
[[nodiscard]] double feed_of(const Settings& settings, double asked, double diameter_mm, double rpm);
/// Warning "toolpath.chip_load": below 10 um a tooth an edge rubs instead of cutting.
/// @param key of the feed, "machining.feed_mm_per_min" @param where the file
[[nodiscard]] core::Finding judge_chip_load(const Settings& settings, double asked, double diameter_mm, double rpm, const char* key,
                                            const char* where);

}  // namespace fusee::toolpath
