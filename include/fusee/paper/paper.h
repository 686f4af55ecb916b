#pragma once
#include <string>
#include <vector>

#include "fusee/actuator/hill.h"
#include "fusee/actuator/noise.h"
#include "fusee/identification/identification.h"
#include "fusee/pipeline/simulation.h"
#include "fusee/search/design_report.h"

/// The paper's tables and figures, reproduced (docs/guides/paper.md).
namespace fusee::paper {

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
    identification::Identification figure_8;
    search::codesign::SearchReport figure_9;
    std::vector<pipeline::Simulation> relatives;           ///< with the position loops of their profiles
    std::vector<actuator::ArrangementRow> torque_control;  ///< the same without these loops, in the same order
};

}  // namespace fusee::paper
