#pragma once
#include <array>
#include <string>

namespace fusee::math {
struct Jet;
}

namespace fusee::spring {

enum class BaseKind {
    kTorsion,      ///< coiled torsion spring behind a K_SE spool: state in rad, load in Nm
    kCompression,  ///< linear compression spring behind a K_PE cam: state in m, load in N
};

/// Hand of a coil: right like a common screw: its coils rise counter-clockwise.
enum class Hand { kUnknown, kRight, kLeft };

/// Class of patented cold drawn wire by EN 10270-1: S static, D dynamic duty; L, M, H: low, medium, high strength.
enum class WireClass { kUnknown, kSl, kSm, kSh, kDm, kDh };
/// The names that profiles use, in the order of WireClass.
inline constexpr std::array kWireClassNames{"unknown", "sl", "sm", "sh", "dm", "dh"};

/// Where the rate comes from: the drawing of its coils, or a measurement of the spring itself.
enum class RateOrigin { kNominal, kMeasured };

/// The linear spring that a cam turns into a nonlinear one. The wire data are optional (0 = unknown) and used only by the checks.
struct BaseSpring {
    BaseKind kind = BaseKind::kTorsion;
    double rate = 0.0;           ///< k_t [Nm/rad] or k [N/m]
    double preload = 0.0;        ///< phi0 [rad] or y0 [m], at the law's lowest load
    double max_state = 0.0;      ///< largest allowed phi + phi0 [rad] or y + y0 (travel to solid) [m]; 0 = unknown
    double max_load = 0.0;       ///< largest allowed torque [Nm] or force [N]; 0 = unknown
    double wire_diameter = 0.0;  ///< [m]
    double coil_diameter = 0.0;  ///< mean [m]
    double active_coils = 0.0;
    double free_length = 0.0;       ///< compression spring [m]
    double tensile_strength = 0.0;  ///< UTS of the wire [Pa]; 0 = that of its class
    WireClass wire_class = WireClass::kUnknown;
    double youngs_modulus = 206e9;  ///< E [Pa]: EN 13906-3, patented drawn wire
    double shear_modulus = 81.5e9;  ///< G [Pa]: EN 13906-1, patented drawn wire
    double stress_share = 0.0;      ///< allowed share of UTS; 0 = 0.7 torsion, 0.8 compression (in shear over sqrt 3)
    double leg_bend_radius = 0.0;   ///< inner radius of the bend to a torsion spring's leg [m]; 0 = the wire's diameter
    Hand hand = Hand::kUnknown;
    double rod_diameter = 0.0;  ///< of the arbor or guide rod inside its coils [m]; 0 = unknown
    double cycles = 0.0;        ///< wanted number of load cycles over the working range; 0 = fatigue not checked
    double motion = 5.0;        ///< frequency of the fastest motion that loads the spring [Hz]
    RateOrigin rate_origin = RateOrigin::kNominal;

    /// phi + phi0 or y + y0 after `energy` [J] was added to the preloaded spring: sqrt(preload^2 + 2 energy / rate).
    [[nodiscard]] double state(double energy) const;
    [[nodiscard]] math::Jet state(const math::Jet& energy) const;  ///< the same over a box (math/interval.h)
    /// Torque [Nm] or force [N] in that state.
    [[nodiscard]] double load(double energy) const { return rate * state(energy); }
};

/// A base spring in series with a cable of that compliance [m/N], as the one linear spring that the cam pulls: both carry the load, their
/// deflections add (docs/theory/cams.md, eq. 21). At its preload it holds the same load as the base spring at its preload:
///     1/rate = 1/k + compliance,  preload = y0 (1 + k compliance)
/// Compliance 0 returns the spring. Limits and wire stay those of the base spring without cable. @pre compliance >= 0
[[nodiscard]] BaseSpring in_series_with_cable(BaseSpring base, double compliance);

}  // namespace fusee::spring
