#pragma once
#include <string>
#include <vector>

#include "fusee/actuator/hill.h"
#include "fusee/actuator/noise.h"
#include "fusee/report/identification.h"
#include "fusee/report/search.h"
#include "fusee/report/simulation.h"

/// The paper's tables and figures anew, to files that a program (JSON, CSV) or a person (HTML, text) reads (docs/guides/paper.md).
namespace fusee::report {

/// Figure 1 for one choice of noises: variances over the stiffness c between motor and joint.
struct NoiseCurve {
    std::string name;
    actuator::NoisePath path;          ///< all but c
    std::vector<double> c;             ///< ascending [Nm/rad]
    std::vector<double> motor, joint;  ///< variances [rad^2]
    std::vector<double> slope;         ///< d(joint)/dc: above 0 a stiffer c rejects less noise [rad^3/Nm]
    std::string refusal;               ///< why the noise has no bound, then there are no columns
    /// The paper's claim: a stiffer c nowhere lets more noise through. A slope below a billionth of joint/c counts as 0.
    [[nodiscard]] bool monotone() const;
};

/// Figure 2: one muscle in both arrangements, and what is left of that with nonlinear springs.
struct HillFigure {
    actuator::LinearMuscle series, parallel;
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

/// A table of the paper beside what springs of its kind do.
struct PaperTable {
    Simulation simulation;             ///< its `measured` rows are the paper's
    std::vector<double> parallel;      ///< stiffness of K_PE that each row's width would need, if it were linear [Nm/rad]
    double travel = 0.0;               ///< of the capstan between first and last row, if these held [rad]
    [[nodiscard]] bool rises() const;  ///< each width above the one before, as measured
};

/// Everything that is made anew. Figures 3 to 5 and 7 are drawings.
struct Paper {
    core::Provenance provenance;
    std::vector<NoiseCurve> figure_1;
    HillFigure figure_2;
    PaperTable table_1;  ///< the first prototype; its path is figure 6
    PaperTable table_2;  ///< new springs
    Identification figure_8;
    SearchReport figure_9;
    std::vector<Simulation> relatives;                     ///< with the position loops of their profiles
    std::vector<actuator::ArrangementRow> torque_control;  ///< the same without these loops, in the same order
};

/// One line of the overview: what the paper says, and what was found here.
struct PaperClaim {
    std::string piece;  ///< "figure 1"
    std::string paper, here;
};
[[nodiscard]] std::vector<PaperClaim> claims(const Paper& paper);

/// Columns of the CSV files: docs/guides/paper.md; 17 digits.
[[nodiscard]] std::string figure_1_csv(const std::vector<NoiseCurve>& curves);
[[nodiscard]] std::string figure_2_csv(const HillFigure& figure);
[[nodiscard]] std::string figure_2_passive_csv(const HillFigure& figure);
[[nodiscard]] std::string figure_6_csv(const ReleasePath& path);
[[nodiscard]] std::string figure_8_csv(const Identification& identification);
[[nodiscard]] std::string figure_9_springs_csv(const LawCurves& law);
[[nodiscard]] std::string figure_9_arms_csv(const std::vector<CamCurve>& cams);
[[nodiscard]] std::string table_csv(const PaperTable& table);
/// The keys of docs/guides/paper.md, in that order; a NaN is null.
[[nodiscard]] std::string paper_json(const Paper& paper);
/// One page in one file that opens offline: no script, no request.
[[nodiscard]] std::string paper_html(const Paper& paper);
/// The overview for a terminal.
[[nodiscard]] std::string paper_text(const Paper& paper);

}  // namespace fusee::report
