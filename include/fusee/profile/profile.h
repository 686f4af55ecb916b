#pragma once
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fusee/actuator/noise.h"
#include "fusee/actuator/relatives.h"
#include "fusee/assembly/options.h"
#include "fusee/cam/cam.h"
#include "fusee/cam/wrap_friction.h"
#include "fusee/checks/check.h"
#include "fusee/core/csv.h"
#include "fusee/design/algorithm_1.h"
#include "fusee/design/budget.h"
#include "fusee/design/search.h"
#include "fusee/drawing/sheet.h"
#include "fusee/solid/part.h"
#include "fusee/spring/base_spring.h"
#include "fusee/spring/laws.h"
#include "fusee/spring/potential.h"
#include "fusee/toolpath/settings.h"

/// One TOML file to the options of the modules, and back. Each module owns its options and their defaults; this one only translates.
///
/// Example:
/// @code
/// const profile::Profile p = profile::read_profile("profiles/pnrvsa.toml");
/// std::cout << p.name << ' ' << p.sha256 << '\n';
/// profile::Profile other = profile::parse_profile(profile::to_toml(p), "profiles/other.toml");  // the same numbers, bit for bit
/// other.cable.diameter = 1e-3;  // SI units in every member
/// core::write_file("profiles/other.toml", profile::to_toml(other));
/// @endcode
namespace fusee::profile {

/// Two columns of a CSV file, the first ascending, in SI; empty without a file.
struct Rows {
    std::filesystem::path file;  ///< as written in the profile, relative to the profile's folder
    std::vector<double> x, y;
};

/// The numbers of actuator::Actuator; the law joins them in the pipeline.
struct Rig {
    actuator::Arrangement arrangement = actuator::Arrangement::kPnrvsa;
    double position_stiffness = 0.0;         ///< of a position loop at each motor of the other arrangements [Nm/rad]
    double cross_stretch = 1.0;              ///< of a cross-coupled joint's third spring before the motors turn [rad]
    double capstan_radius = 0.0;             ///< r_c [m]
    double joint_radius = 0.0;               ///< r_j [m]
    double gear_friction = 0.0;              ///< mu
    double gear_friction_constant = 0.0;     ///< [Nm]
    double gear_friction_rest_excess = 0.0;  ///< friction at rest over friction in motion, minus 1
    /// mu of a resting gear, for the (k, u, C) law.
    [[nodiscard]] double rest_friction() const { return (1.0 + gear_friction_rest_excess) * gear_friction; }
    Rows gear_friction_table;  ///< friction over load [Nm]; instead of mu and constant
    actuator::OutputFriction joint_friction;
    double least_torque = 0.0;      ///< [Nm]
    double peak_torque = 0.0;       ///< [Nm]
    double overdrive_torque = 0.0;  ///< [Nm]
};

/// F(x) = sum_i c_i x^i of both springs over the capstan's angle: arguments of spring::make_polynomial.
struct PolynomialPair {
    std::vector<double> series, parallel;  ///< [Nm/rad^i]
};

/// F(x) = scale (exp(rate x) - 1) + offset of both springs: arguments of spring::make_exponential.
struct ExponentialPair {
    struct Curve {
        double scale = 0.0;   ///< [Nm]
        double rate = 0.0;    ///< [1/rad]
        double offset = 0.0;  ///< [Nm]
    };
    Curve series, parallel;
};

/// Measured curves of both springs: arguments of spring::make_tabulated.
struct TablePair {
    std::filesystem::path file;            ///< as written in the profile, relative to the profile's folder
    std::vector<double> angle;             ///< capstan angle, ascending [rad]
    std::vector<double> series, parallel;  ///< torque [Nm]
    spring::TableOptions smoothing;
};

/// The law of a profile of kind "spring": the torque of one spring over its angle, of either sign; positive: against a rising angle.
struct OneSpring {
    enum class Kind { kConstant, kGravity, kPolynomial, kExponential, kStiffness, kFormula, kPoints, kTable };
    Kind kind = Kind::kConstant;
    core::Range angles;                ///< of the law [rad]; points and a table have those of their rows
    double torque = 0.0;               ///< constant; of a stiffness: the torque at the first angle [Nm]
    double mass = 0.0, lever = 0.0;    ///< gravity: m g l sin(angle) [kg], [m]
    std::vector<double> coefficients;  ///< polynomial [Nm/rad^i]
    ExponentialPair::Curve exponential;
    std::string formula;  ///< in x, the angle [rad]: torque [Nm] or stiffness [Nm/rad]
    Rows rows;            ///< angle [rad], torque [Nm]: of points without a file
    spring::TableOptions smoothing;
    enum class Family { kSpool, kCable, kTwoCables, kRoller };
    Family family = Family::kCable;  ///< of its part
    /// Two cables on one shaft, one each way, each with a spring of its own (docs/theory/cams.md, eq. 23): both stay taut.
    struct TwoCables {
        double least_torque = 0.0;  ///< of each cable [Nm]
        double back_preload = 0.0;  ///< y0 of the way back at the last angle [m]; 0: that of the other spring
        double back_turned = 0.0;   ///< direction of its guide, from that of the other one about +z [rad]
        /// What the cable pulls with whose way the law's torque has [Nm]; that of -torque is what the other one pulls with.
        [[nodiscard]] double pull(double torque) const { return least_torque + 0.5 * (torque + std::hypot(torque, 2.0 * least_torque)); }
        enum class Way { kBoth, kForth, kBack } way = Way::kBoth;  ///< kForth, kBack: the profile is that of one of both cables alone
    } two_cables;
    /// Is the profile that of the cable alone that pulls back?
    [[nodiscard]] bool pulls_back() const { return two_cables.way == TwoCables::Way::kBack; }
    /// Of the law [rad].
    [[nodiscard]] double first_angle() const { return rows.x.empty() ? angles.low : rows.x.front(); }
};

/// A curve over the torque tau [Nm]: a formula, or rows; neither: chosen by the program.
struct TorqueCurve {
    std::string formula;
    Rows rows;
};

/// Springs from the wanted dead-band: source of spring::DeadBandLawOptions.
struct DeadBandSpec {
    TorqueCurve dead_band;            ///< full width at the joint [rad]; its formula gives degrees
    TorqueCurve series_stiffness;     ///< S [Nm/rad]; neither: S = k tau^2
    double start_transmission = 0.5;  ///< T at the start torque, when S is chosen
};

/// The wanted spring law. StictionLawOptions are complete: mu of the rig, torques of this law; so are FreeCurveOptions.
struct LawSpec {
    std::variant<spring::StictionLawOptions, PolynomialPair, ExponentialPair, TablePair, DeadBandSpec, spring::FreeCurveOptions, OneSpring>
        curves;
    double start_torque = 0.0;    ///< lowest load [Nm] without lead-in; of a free curve its first
    double end_torque = 0.0;      ///< highest load [Nm]
    double lead_in_travel = 0.0;  ///< argument of spring::with_lead_in [rad]
};

/// One cam: its base spring, its path and its body.
struct PartSpec {
    spring::BaseSpring spring;
    cam::Allowance allowance;
    double cable_length = 0.0;  ///< unloaded, anchor on the cam to what the cable pulls, wound part included [m]; 0: rigid
    cam::CamOptions cam;
    solid::PartOptions solid;
};

/// Files to write in addition to springs.csv, the reports and PART.json.
struct Outputs {
    std::vector<std::string> formats;  ///< names of formats::all_formats, in its order
    bool pair = true;                  ///< also the antagonist's parts, mirror images of the agonist's
    bool plate = true;                 ///< with 3MF: all parts on one plate
    double kerf = 0.0;                 ///< of a beam or wire [m]; above 0: a second DXF, moved by half of it
    int springs_rows = 400;            ///< rows of springs.csv, >= 200

    [[nodiscard]] bool has(std::string_view format) const;
};

/// Settings of `fusee simulate`.
struct SimulationSettings {
    int levels = 15;           ///< of co-contraction, least to overdrive torque
    double push_torque = 0.0;  ///< at the joint [Nm]; 0: strong enough
    Rows measured;             ///< dead-band [rad], full width at the joint, over co-contraction [Nm]
};

/// All input of a design. Cable diameter, groove and chordal error appear once in the file, and here in both parts.
struct Profile {
    Profile();
    // Not inline: each unit that copies or destroys one would compile it.
    Profile(const Profile&);
    Profile(Profile&&) noexcept;
    Profile& operator=(const Profile&);
    Profile& operator=(Profile&&) noexcept;
    ~Profile();

    std::string name;            ///< letters, digits, '.', '_', '-': also the name of the design's folder
    std::filesystem::path file;  ///< the file that was read
    std::string sha256;          ///< of the TOML's bytes followed by those of the CSV files it names: `cat a.toml a.csv | sha256sum`
    Rig rig;
    LawSpec law;
    actuator::NoiseOptions dynamics;
    SimulationSettings simulate;
    design::SearchOptions search;
    design::Algorithm1Options algorithm_1;
    design::CoDesignOptions co_design;
    bool has_parts = true;  ///< false: the file has none of the tables below; it can be simulated but not made
    PartSpec k_se, k_pe;
    checks::Cable cable;
    cam::WrapFriction wrap;  ///< of that cable on its cams
    checks::Process process;
    assembly::AssemblyOptions assembly;
    design::budget::BudgetOptions budget;
    std::vector<checks::Override> limits;  ///< instead of the rules' defaults, in the file's order
    toolpath::Settings machining;
    Outputs outputs;
    drawing::TitleOptions title;                ///< of the shop drawings
    solid::Compensation compensation;           ///< from measured coupons; the cable's axis is in both parts' allowance
    core::CsvMapping columns;                   ///< table [columns]: how the profile's CSV files name their columns
    std::map<std::string, std::string> places;  ///< of the keys in the file: "file:line:column: key"

    /// Kind "spring": one spring and its part, no rig.
    [[nodiscard]] bool is_spring() const { return std::holds_alternative<OneSpring>(law.curves); }
    /// A single spring of two cables, both of them.
    [[nodiscard]] bool has_two_cables() const;
    /// The parts that the profile describes: both, or the one of a single spring.
    [[nodiscard]] std::vector<cam::PartKind> part_kinds() const;
    [[nodiscard]] PartSpec& part(cam::PartKind kind) { return kind == cam::PartKind::kSeries ? k_se : k_pe; }
    [[nodiscard]] const PartSpec& part(cam::PartKind kind) const { return kind == cam::PartKind::kSeries ? k_se : k_pe; }
    /// The table of a part: "k_se", "k_pe", or "cam" of a single spring.
    [[nodiscard]] std::string table_of(cam::PartKind kind) const { return is_spring() ? "cam" : to_string(kind); }
    /// The beginning of the names of a part's files: its table, or "cam_back" of the cable that pulls back.
    [[nodiscard]] std::string name_of(cam::PartKind kind) const;
    /// A text about a part in the words of this profile: of a single spring with "cam" instead of "k_pe".
    [[nodiscard]] std::string in_its_words(std::string text) const;
    /// Place of a key; file and key if it is not in the file.
    [[nodiscard]] std::string place_of(const std::string& key) const;
};

/// The name of a design: 1 to kLongestName letters, digits, '.', '_' or '-', beginning with a letter or digit.
[[nodiscard]] bool is_name(std::string_view text);
inline constexpr std::size_t kLongestName = 64;
inline constexpr const char* kAllowedName = "a text of 1 to 64 letters, digits, '.', '_' or '-', beginning with a letter or digit";

/// Largest profile or table [bytes].
inline constexpr std::size_t kLargestFile = 10'000'000;

/// Reads a profile and the CSV files that it names (docs/profile.md lists every key).
/// @throws core::IoError if the file is missing, too large or not TOML (line and column)
/// @throws core::InvalidInput, of several core::InvalidInputs: "file:line:column: key": unknown key, wrong type, NaN, out of range, missing
[[nodiscard]] Profile read_profile(const std::filesystem::path& path);
/// The same from the text of `path`, which need not exist yet. @throws as read_profile
[[nodiscard]] Profile parse_profile(std::string toml, const std::filesystem::path& path);

/// The curves of a CSV file as `law.file` names it, with the default smoothing. @throws core::IoError; as read_profile for its rows
[[nodiscard]] TablePair read_measured_law(const std::filesystem::path& file, const core::CsvMapping& mapping = {});

/// The profile as TOML with every key that applies. Read from the same folder it gives the same numbers, bit for bit.
[[nodiscard]] std::string to_toml(const Profile& profile);

/// The same as a person writes it: the keys that differ from their defaults, and the required ones, each with its meaning.
[[nodiscard]] std::string to_commented_toml(const Profile& profile);

/// Every number rounded to `digits` significant digits in the unit of its key, as the reader gives it back. @pre digits within 1 to 17
[[nodiscard]] Profile rounded(Profile profile, int digits);

/// Every key with unit, allowed values, default and meaning, as Markdown tables (`fusee keys --markdown`).
[[nodiscard]] std::string profile_reference();

}  // namespace fusee::profile
