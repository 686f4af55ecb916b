#pragma once
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fusee/actuator/dead_band.h"
#include "fusee/actuator/joint.h"
#include "fusee/cam/certificate.h"
#include "fusee/core/finding.h"
#include "fusee/core/provenance.h"
#include "fusee/formats/format.h"
#include "fusee/pipeline/as_exported.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/headline.h"
#include "fusee/readback/readback.h"
#include "fusee/solid/part.h"
#include "fusee/solid/validity.h"
#include "fusee/spring/base_spring.h"
#include "fusee/spring/law.h"

/// A design and its part files (docs/report.md).
namespace fusee::assembly {
struct Assembly;
}

namespace fusee::pipeline {

/// One row of a measured table, with the springs that were smoothed from it.
struct TableRow {
    double angle = 0.0;                                 ///< of the capstan, as in the file [rad]
    double series = 0.0, parallel = 0.0;                ///< as in the file [Nm]
    double series_smooth = 0.0, parallel_smooth = 0.0;  ///< of the smoothed springs there [Nm]
};
/// A measured table, and the law that was smoothed from it.
struct SmoothedTable {
    std::string file;
    std::vector<TableRow> rows;  ///< all of the file's; not empty

    [[nodiscard]] Misfit series() const;
    [[nodiscard]] Misfit parallel() const;
};

/// The pair of spring laws as designed.
struct LawReport {
    std::vector<spring::LawPoint> samples;                                   ///< by rising load, lead-in included; at least 2
    core::Range design_loads;                                                ///< loads without the lead-in [Nm]
    double lead_in_travel = 0.0;                                             ///< capstan travel of the low-load law [rad]
    double least_feasible_start = std::numeric_limits<double>::quiet_NaN();  ///< tau_min [Nm]; NaN: not defined for the kind of law
    core::Range stiction_loads;          ///< possible loads of resting capstans: actuator::Actuator::loads [Nm]
    std::optional<SmoothedTable> table;  ///< of a law of kind "table"
    /// Do the springs reach every load that stiction allows?
    [[nodiscard]] bool covers_stiction() const;
};

using formats::FileRow, formats::file_row;

using exchange::OnShaft;

/// One part with its files.
struct PartReport {
    std::string name;                         ///< of its files: "k_se", "k_pe_mirrored", "cam"
    std::shared_ptr<const solid::Part> part;  ///< never null
    spring::BaseSpring spring;
    core::Findings findings;
    std::vector<FileRow> files;
    std::vector<readback::ArmError> arm_errors;
    solid::Quality quality;             ///< of part->mesh
    cam::Certificate certificate;       ///< of part->cam
    std::optional<OnShaft> shaft = {};  ///< of a spool of two cables
};

/// The torque of two cables together, at the working rows of the part that pulls forth.
struct TorqueOfBoth {
    std::vector<double> angle;        ///< of the law [rad]
    std::vector<double> wanted;       ///< forth - back [Nm]
    std::vector<double> forth, back;  ///< of each cable [Nm]
    std::vector<double> found;        ///< by the arms of the first files, as read back [Nm]; empty: no file was read
};

/// A design with all of its files.
struct DesignReport {
    core::Provenance provenance;
    LawReport law;
    actuator::Actuator actuator;                ///< of both sides; its law is that of `law`
    std::vector<actuator::DeadBand> dead_band;  ///< by rising co-contraction
    core::Findings findings;                    ///< of the law and of the design as a whole
    std::vector<PartReport> parts;
    std::vector<PartReport> mirrored;              ///< their mirror images, for the antagonist; none if the profile asks for none
    std::vector<FileRow> files;                    ///< that belong to no part: springs.csv, plate.3mf
    std::vector<readback::ArmError> plate_errors;  ///< of each part as it stands in plate.3mf
    AsExported as_exported;
    std::optional<TorqueOfBoth> of_both;  ///< of a single spring of two cables
    Headline headline;
    std::shared_ptr<const assembly::Assembly> assembly;  ///< null: not modelled; `findings` say why
    /// `parts`, then `mirrored`.
    [[nodiscard]] std::vector<const PartReport*> sides() const;
    /// The arm errors of every file: the sides', then the plate's.
    [[nodiscard]] std::vector<const readback::ArmError*> arm_errors() const;
    /// The findings of the law, the design and every part.
    [[nodiscard]] core::Findings all_findings() const;
    /// Largest relative arm error of the files, prints left out; NaN if none was read back.
    [[nodiscard]] double worst_arm_error() const;
    [[nodiscard]] FileErrors file_errors() const { return {worst_arm_error(), as_exported.worst_change()}; }
};

/// kPass: can be made; kNotJudged: can be made as far as its rules could be judged; kWarning: a person must accept something; kError:
/// cannot be made, or a file does not carry the law.
[[nodiscard]] core::Severity verdict(const DesignReport& design);

/// The joint that both parts belong to, judged.
struct Assembled {
    std::shared_ptr<const assembly::Assembly> assembly;  ///< null: not modelled; the findings say why
    core::Findings findings;
};
[[nodiscard]] Assembled assemble(const ResolvedDesign& design, std::shared_ptr<const solid::Part> k_se,
                                 std::shared_ptr<const solid::Part> k_pe);

}  // namespace fusee::pipeline
