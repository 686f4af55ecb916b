#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "fusee/checks/check.h"
#include "fusee/core/finding.h"
#include "fusee/profile/profile.h"

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
    double bed = 0.2;  ///< side of the machine's bed or of the stock [m]

    /// Torques at the capstan [Nm], defaults filled in.
    [[nodiscard]] double peak_torque() const { return torque / ratio; }
    [[nodiscard]] double overdrive_torque() const { return (overdrive > 0.0 ? overdrive : 1.5 * torque) / ratio; }
    [[nodiscard]] double least_torque() const { return (least > 0.0 ? least : 0.85 * torque) / ratio; }
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

    /// "Torque of one motor at the joint, held for long in Nm (0.001 to 1000) [1]: "
    [[nodiscard]] std::string prompt(const Answers& answers) const;
};

/// All questions in the order in which they are asked.
[[nodiscard]] std::span<const Question> questions();

/// The options that give `answers` again: "--torque 2 --cable "steel 1.5""; an answer equal to its default is left out.
[[nodiscard]] std::string options_text(const Answers& answers);

struct Options {
    unsigned jobs = 0;  ///< threads; 0: one per processor; no influence on the result
    /// Called with the share of the work done, 0 to 1, and the present step; may be empty.
    std::function<void(double share, const std::string& step)> progress = {};
    std::function<bool()> stop = {};  ///< asked often; may be empty
};

/// A design for `answers`: the shipped pnrvsa scaled to them, then co-designed, with springs that can be wound.
struct Design {
    profile::Profile profile;
    core::Findings findings;  ///< of every rule, solids included: no error; no rule of springs, cable or material is open
};

/// The nearest joint that can be made, if the wanted one cannot.
struct NearestChange {
    core::Change answer;  ///< {"--cable", "fibre 1", "fibre 0.8"}
    std::string options;  ///< all options of the joint that can be made, for a command line
};

struct Result {
    std::optional<Design> design;
    core::Findings binding;                ///< without a design: the limits that the best candidate breaks, the worst first
    std::optional<NearestChange> nearest;  ///< without a design: the least change of one answer that gives one; none if none was found
    std::size_t judged = 0;                ///< candidates judged
};

/// @param name of the design @throws core::InvalidInput naming the option; core::Stopped when `stop` says so
[[nodiscard]] Result find_design(const std::string& name, const Answers& answers, const Options& options);

/// The commented profile of a design: every key that differs from its default, with the meaning from the schema of keys.
[[nodiscard]] std::string profile_text(const Design& design, const Answers& answers);

}  // namespace fusee::search::init
