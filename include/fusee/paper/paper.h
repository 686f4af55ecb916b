#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fusee/actuator/noise.h"
#include "fusee/core/finding.h"
#include "fusee/core/progress.h"
#include "fusee/gap_case/break_away.h"
#include "fusee/pipeline/simulation.h"
#include "fusee/search/design_report.h"
#include "fusee/spring/potential.h"

/// The paper's tables and figures, reproduced (docs/guides/paper.md).
namespace fusee::paper {

/// Figure 2, two arrangements of Hill's muscle, as the paper uses them (docs/theory/hill.md):
/// "series": K_SE in series with (contractile element parallel to K_PE): F = F_SE(L - l) = F_PE(l) + f. The actuator's own arrangement.
/// "parallel": K_PE parallel to (contractile element in series with K_SE): F = F_PE(L) + f, f = F_SE(L - x).
/// L is the stretch of the whole muscle, l and x that of the contractile element, f its active force. With linear springs the two are
/// equivalent by the map below (McMahon, Muscles, Reflexes, and Locomotion, 1984, p. 23): equal force at every L, equal work of the
/// contractile element. Every function: @throws InvalidInput naming the stiffness unless k_se > 0 and k_pe >= 0
struct LinearMuscle {
    double k_se = 0.0;  ///< [N/m] or [Nm/rad], > 0
    double k_pe = 0.0;  ///< >= 0
};
/// Force of the series arrangement at stretch L under active force f.
[[nodiscard]] double series_force(const LinearMuscle& muscle, double length, double active);
/// Stretch l of its contractile element in that state.
[[nodiscard]] double series_contractile(const LinearMuscle& muscle, double length, double active);
/// Force of the parallel arrangement at stretch L with contractile stretch x.
[[nodiscard]] double parallel_force(const LinearMuscle& muscle, double length, double contractile);
/// The parallel arrangement that is equivalent to a series one.
[[nodiscard]] LinearMuscle parallel_from_series(const LinearMuscle& muscle);
/// Stretch x of the parallel arrangement's contractile element for active force f of the series one at stretch L.
[[nodiscard]] double contractile_from_active(const LinearMuscle& series, double length, double active);

/// Nonlinear springs: the passive tension of the series arrangement is that of both springs in series, with equal forces: the K_PE of the
/// parallel arrangement, a potential over L. Its domain begins where both springs are off their stops and ends at the first spring's end.
/// @throws InvalidInput naming the spring if one is missing or not stiff (U'' > 0) throughout, or if no force is common to both
[[nodiscard]] spring::PotentialPtr passive_tension(spring::PotentialPtr k_se, spring::PotentialPtr k_pe);

/// Figure 1 for one choice of noises: variances over the stiffness c between motor and joint.
struct NoiseCurve {
    std::string name;
    actuator::NoisePath path;          ///< all but c
    std::vector<double> c;             ///< ascending [Nm/rad]
    std::vector<double> motor, joint;  ///< variances [rad^2]
    std::vector<double> slope;         ///< d(joint)/dc: above 0 a stiffer c rejects less noise [rad^3/Nm]
    std::string refusal;               ///< why the noise has no bound, then there are no columns
    /// The paper's claim: a stiffer c never passes more noise. A slope below a billionth of joint/c counts as 0.
    [[nodiscard]] bool monotone() const;
};

/// Figure 2: one muscle in both arrangements, and the difference that remains with nonlinear springs.
struct HillFigure {
    LinearMuscle series, parallel;
    struct Row {
        double active = 0.0;                  ///< force of the series arrangement's contractile element [Nm]
        double length = 0.0;                  ///< of the muscle [rad]
        double series = 0.0, parallel = 0.0;  ///< force of the muscle [Nm]
    };
    std::vector<Row> rows;  ///< by active force, then by length
    struct Passive {
        double length = 0.0;  ///< [rad]
        double force = 0.0;   ///< [Nm]
    };
    std::vector<Passive> passive;                     ///< of nonlinear springs, no active force
    [[nodiscard]] double largest_difference() const;  ///< between the arrangements [Nm]
};

/// A table of the paper, and the simulation of springs of its kind.
struct PaperTable {
    pipeline::Simulation simulation;   ///< its `measured` rows are the paper's
    std::vector<double> parallel;      ///< stiffness of K_PE that each row's width would need, if it were linear [Nm/rad]
    double travel = 0.0;               ///< of the capstan between first and last row, if these held [rad]
    [[nodiscard]] bool rises() const;  ///< each width above the one before, as measured
};

/// All reproduced tables and figures. Figures 3 to 5 and 7 are drawings.
struct Paper {
    core::Provenance provenance;
    std::vector<NoiseCurve> figure_1;
    HillFigure figure_2;
    PaperTable table_1;  ///< the first prototype; its path is figure 6
    PaperTable table_2;  ///< new springs
    gap_case::Identification figure_8;
    search::codesign::SearchReport figure_9;
    std::vector<pipeline::Simulation> relatives;           ///< with the position loops of their profiles
    std::vector<actuator::ArrangementRow> torque_control;  ///< the same without these loops, in the same order
};

struct PaperOptions {
    std::filesystem::path profiles = "profiles";  ///< holds first_prototype.toml, pnrvsa.toml, paper/, relatives/ and examples/
    unsigned jobs = 0;                            ///< threads of figure 9's search; 0 = one for each processor; no influence on the result
    std::function<void(const std::string& piece)> note = {};  ///< called after each finished piece, kPieces times; may be empty
    std::function<bool()> stop = core::interrupted;           ///< asked before each piece
};
inline constexpr std::size_t kPieces = 7;

struct Result {
    std::optional<Paper> paper;  ///< none: interrupted or refused
    bool interrupted = false;
    core::Findings findings;  ///< refused: which law cannot exist, and why
};

/// Reproduces every table and figure of the paper (docs/guides/paper.md). Writes nothing. @throws core::InvalidInput, core::IoError
[[nodiscard]] Result run(const PaperOptions& options = {});

}  // namespace fusee::paper
