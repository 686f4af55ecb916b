#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fusee/checks/check.h"
#include "fusee/core/finding.h"
#include "fusee/profile/profile.h"
#include "fusee/spring/catalogue.h"

/// A first profile from a few answers (docs/guides/init.md).
namespace fusee::search::init {

/// What a person knows of a joint before its first cams. Torques of one motor, full values; SI.
struct Answers {
    double torque = 1.0;                    ///< of one motor at the joint, held for long [Nm]
    double overdrive = 0.0;                 ///< the same for a short time [Nm]; 0: 1.5 times `torque`
    double least = 0.0;                     ///< least co-contraction used, at the joint [Nm]; 0: 0.85 times `torque`
    double ratio = 1.0;                     ///< r_j/r_c: turns of a capstan for one turn of the joint
    double joint_range = 0.0;               ///< between the joint's stops [rad]; 0: what the springs allow
    std::optional<profile::TablePair> law;  ///< measured springs at the capstan, the loading branch; none: a law of the paper's kind
    core::CsvMapping columns;               ///< of the files of measured springs and of break-away tests
    double joint_stiffness = 0.0;           ///< capstans held, at `torque` of co-contraction [Nm/rad]; 0: chosen
    double friction = 0.28;                 ///< gear friction over the load on the capstan
    double friction_constant = 0.0;         ///< its part that does not depend on the load [Nm]
    std::string construction = "fibre";
    double cable = 0.8e-3;       ///< diameter [m]
    double breaking_load = 0.0;  ///< [N]; 0: that of a usual cable of this construction and diameter
    double shaft = 6e-3;         ///< diameter [m]
    checks::ProcessKind process = checks::ProcessKind::kFdm;
    std::string material = checks::kByProcess;
    double bed = 0.2;   ///< side of the machine's bed or of the stock [m]
    double size = 0.0;  ///< largest diameter of spool, cam, capstan and joint's pulley [m]; 0: `bed`

    bool spring = false;     ///< one spring is wanted, no joint: then the figures below, those of part and shop, no others
    std::string torque_law;  ///< its torque: a CSV file, or a formula in x, the angle [rad]
    double first_angle = 0.0, last_angle = 0.0;  ///< of a formula [rad]

    /// Torques at the capstan [Nm], defaults filled in.
    [[nodiscard]] double peak_torque() const { return torque / ratio; }
    [[nodiscard]] double overdrive_torque() const { return (overdrive > 0.0 ? overdrive : 1.5 * torque) / ratio; }
    [[nodiscard]] double least_torque() const { return (least > 0.0 ? least : 0.85 * torque) / ratio; }
    /// Largest diameter of a part that turns [m].
    [[nodiscard]] double largest_size() const { return size > 0.0 ? size : bed; }
};

/// @throws core::InvalidInput naming the option, if two answers exclude each other: an overdrive torque below the torque, a torque beyond
/// the measured law
void require_consistent(const Answers& answers);

/// One question of `fusee init`, and the option that answers it in a script.
struct Question {
    std::string option;                                            ///< "--torque"
    std::string text;                                              ///< "Torque of one motor at the joint, held for long"
    std::string unit;                                              ///< "Nm"; empty: none
    std::string allowed;                                           ///< "0.001 to 1000", "fdm, sla or mill"
    std::function<std::string(const Answers&)> shown;              ///< the answer now, as a person enters it
    std::function<void(Answers&, const std::string& text)> enter;  ///< @throws core::InvalidInput, core::IoError
    std::string help = {};                                         ///< what "?" answers: one or two sentences
    bool of_law = true;                                            ///< of the law and its loads, else of part and shop
    bool of_formula = false;                                       ///< not asked where the law is a file

    /// "Torque of one motor at the joint, held for long in Nm (0.001 to 1000) [1]: "
    [[nodiscard]] std::string prompt(const Answers& answers) const;
};

/// All questions in the order in which they are asked, of a joint or of one spring.
[[nodiscard]] std::span<const Question> questions(bool spring = false);

/// The options that give `answers` again: "--torque 2 --cable "steel 1.5""; an answer equal to its default is left out.
[[nodiscard]] std::string options_text(const Answers& answers);

struct Result;
/// What can be said of a measured law before part and shop are known: no pair of springs, or it ends before the dead-band's edges, with the
/// least changes of single answers that help. None: no obstacle, or no measured law.
[[nodiscard]] std::optional<Result> refused_by_law(const Answers& answers);

struct InitOptions {
    unsigned jobs = 0;                 ///< threads; 0: one per processor; no influence on the result
    spring::Catalogue catalogue = {};  ///< springs on sale, of which Result::stores names those that hold the law
    bool repair = false;               ///< a measured law that cannot be made may be changed
    /// Called with the share of the work done, 0 to 1, and the present step; may be empty.
    std::function<void(double share, const std::string& step)> progress = {};
    std::function<bool()> stop = {};  ///< asked often; may be empty
};

/// A design for `answers`: the shipped pnrvsa scaled to them, then co-designed, with springs that can be wound.
struct Design {
    profile::Profile profile;
    core::Findings findings;  ///< of every rule, solids included: no error; no rule of springs, cable or material is open
};

/// Other answers, and what has to be typed for them.
struct OtherAnswers {
    core::Changes changes;  ///< {"--cable", "fibre 1", "fibre 0.8"}
    std::string options;    ///< all options of the joint with them, for a command line
};

/// What one spring has to hold, before any contour: whatever the cam, energy is kept.
struct Store {
    cam::PartKind part = cam::PartKind::kSeries;
    double work = 0.0, preload = 0.0;      ///< of the law between its ends, and of the start design's preload [J]
    double least_wire = 0.0;               ///< diameter from which on a wound spring holds both [m]; 0: none up to 5 mm
    double largest = 0.0;                  ///< energy of the largest spring of the last wire tried [J]
    std::size_t offered = 0;               ///< springs of the catalogue of this kind
    std::vector<std::string> bought = {};  ///< those that hold both
    [[nodiscard]] double energy() const { return work + preload; }  ///< [J]
};

/// A measured law that was changed so that it can be made, beside the wanted one.
struct Repair {
    profile::TablePair law;                              ///< of the design
    std::vector<double> wanted_series, wanted_parallel;  ///< at its angles: the smoothed file, beyond it continued [Nm]
    core::Range measured;                                ///< angles of the file [rad]

    /// The least and the greatest change of a torque, and the root mean square over the angle [Nm].
    struct Change {
        double least = 0.0, greatest = 0.0, mean = 0.0;
    };
    [[nodiscard]] Change series_change() const;
    [[nodiscard]] Change parallel_change() const;
};

struct Result {
    std::optional<Design> design;
    std::optional<Repair> repair;         ///< the law of the design, where InitOptions::repair was needed
    std::vector<Store> stores;            ///< of both springs; none where the measured law is no pair of springs
    core::Findings binding;               ///< without a design: the limits that bind, the worst first
    bool at_once = false;                 ///< the binding limits are necessary ones: no candidate was judged
    std::vector<OtherAnswers> levers;     ///< without a design: for each answer that can meet the binding limits alone, its least change
    std::optional<OtherAnswers> nearest;  ///< without a design: the least change found that gives a whole design; none if none was found
    std::size_t judged = 0;               ///< candidates judged
};

/// @param name of the design @throws core::InvalidInput naming the option; core::Stopped when `stop` says so
[[nodiscard]] Result find_design(const std::string& name, const Answers& answers, const InitOptions& options);

/// A profile of one spring from its answers, with a part that `one_spring::find_smallest` is to size. @param file that will hold it
/// @throws core::InvalidInput(s) naming the key; core::IoError
[[nodiscard]] profile::Profile first_spring(const std::filesystem::path& file, const Answers& answers);

/// The law and the wanted one as a CSV file, which a profile can name: angle_rad, series_Nm, parallel_Nm, wanted_series_Nm,
/// wanted_parallel_Nm, and 1 in `measured` where the file had rows. Its numbers are exact.
[[nodiscard]] std::string repair_csv(const Repair& repair);

/// The commented profile of a design: every key that differs from its default, with the meaning from the schema of keys.
[[nodiscard]] std::string profile_text(const Design& design, const Answers& answers);

/// Does an answer name a CSV file? In any case of its ending.
[[nodiscard]] bool names_file(const std::string& answer);

}  // namespace fusee::search::init
