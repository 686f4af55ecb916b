#pragma once

namespace fusee::toolpath {

/// The controller of the machine.
enum class Controller { kLinuxCnc };

/// The method for the groove of a part.
enum class Method {
    kStack,  ///< two plates that meet in the groove's plane, each cut from that face on three axes; planar parts only
    kWrap,   ///< one piece, its blank on three axes, its groove on a rotary axis
};

/// A workshop's machine. The groove gives the cutter of a wrap; all other cuts use the flat end mill.
struct Settings {
    Controller controller = Controller::kLinuxCnc;
    Method k_se = Method::kStack;
    Method k_pe = Method::kWrap;        ///< a helix is always wrapped
    double tool_diameter = 3e-3;        ///< flat end mill [m]
    double feed = 300.0 / 60e3;         ///< of the tool's tip along the part [m/s]
    double plunge_feed = 100.0 / 60e3;  ///< straight down and down a helix [m/s]
    double spindle_rpm = 12000.0;       ///< clockwise [1/min]
    double depth_per_pass = 0.5e-3;     ///< [m]
    double terrace = 0.1e-3;            ///< height of the terraces of a plate's half groove [m]
    double wrap_feed = 100.0 / 60e3;    ///< of the groove's cutter along the part [m/s]
    double wrap_rpm = 20000.0;          ///< [1/min]
    double wrap_depth = 0.1e-3;         ///< of one pass of the groove's cutter [m]
    double safe_height = 5e-3;          ///< above the stock's top: rapids stay there [m]
    double breakthrough = 0.3e-3;       ///< below the stock's bottom, into the board below it [m]
    double tolerance = 1e-6;            ///< largest distance between the contour and the arcs and lines of a program [m]
    int rotary_sign = 1;                ///< 1: a positive A turns the part by the right-hand rule about +X; -1: the other way (ISO 841)
};

/// @throws InvalidInput naming the key of `[machining]` that is not positive or, rotary_sign, neither 1 nor -1
void require_valid(const Settings& settings);

}  // namespace fusee::toolpath
