#include "fusee/pipeline/as_exported.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fusee/actuator/dead_band.h"
#include "fusee/cam/arm.h"
#include "fusee/core/lists.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/design_report.h"
#include "fusee/spring/potential.h"

namespace fusee::pipeline {

namespace {

constexpr double kToTheEnd = 1.0 - 1e-9;  // of the load there, so that its deflection lies inside the law
/// Springs are extended beyond both ends: a design may cover its resting loads exactly, and a file that is short by its chordal error must
/// not lose the dead-band.
constexpr double kBeyond = 0.01;
constexpr int kPlaces = 400;  // over the capstan's travel, where torques are compared

/// The readings of one reader in the files of one format: of K_SE, then of K_PE.
struct Format {
    std::string ending, reader;  ///< ".stl", "assimp"
    std::array<std::vector<const readback::ArmError*>, 2> readings;
    std::array<const PartReport*, 2> parts{};
    std::string mirror_of = {};  ///< ending of the files that were read, of which these are the mirror images; empty: these were read
};

/// One reading and its part.
struct Source {
    const PartReport* part;
    const readback::ArmError* reading;
    std::string ending;  ///< after the part's name: files of the same ending belong to the same joint
    std::string reader;
    std::string mirror_of = {};  ///< ending of the file that was read instead
};

/// The source of a separate file: "k_se_mirrored.ngc" read by "rs274 lower", one of the cuts of a program.
Source of_part(const PartReport& part, const readback::ArmError& reading) {
    const std::string name = cam::to_string(part.part->cam.kind);
    const bool cut = reading.reader.starts_with("rs274 ");
    const auto ending = [&](const std::string& file) { return file.starts_with(name) ? file.substr(name.size()) : file; };
    return {&part, &reading, ending(reading.file), cut ? "rs274" : reading.reader, ending(reading.mirror_of)};
}

/// The source on the plate, whose readers are named "lib3mf k_se_mirrored".
Source of_plate(const DesignReport& design, const readback::ArmError& reading) {
    const std::size_t space = reading.reader.rfind(' ');
    const std::string name = reading.reader.substr(space + 1);
    for (const PartReport* part : design.sides())
        if (const std::string kind = cam::to_string(part->part->cam.kind); name.starts_with(kind))
            return {part, &reading, reading.file + name.substr(kind.size()), reading.reader.substr(0, space)};
    return {nullptr, &reading, "", ""};
}

std::vector<Format> formats(const DesignReport& design) {
    std::vector<Source> sources;
    for (const PartReport* part : design.sides())
        for (const readback::ArmError& reading : part->arm_errors) sources.push_back(of_part(*part, reading));
    for (const readback::ArmError& reading : design.plate_errors) sources.push_back(of_plate(design, reading));
    std::vector<Format> all;
    for (const Source& s : sources) {
        if (s.part == nullptr) continue;
        auto format = std::find_if(all.begin(), all.end(), [&](const Format& f) { return f.ending == s.ending && f.reader == s.reader; });
        if (format == all.end()) format = all.insert(all.end(), Format{s.ending, s.reader, {}, {}, s.mirror_of});
        if (s.mirror_of != format->mirror_of) format->mirror_of.clear();  // one part was read itself: the joint is computed
        const std::size_t part = s.part->part->cam.kind == cam::PartKind::kSeries ? 0 : 1;
        format->readings[part].push_back(s.reading);
        format->parts[part] = s.part;
    }
    return all;
}

/// The arms of the cable over the cam angle: those of the higher one of several adjacent grooves. NaN where one has none.
std::vector<cam::FoundArm> found_arms(const PartReport& part, const std::vector<const readback::ArmError*>& readings) {
    std::vector<cam::FoundArm> arms;
    const auto& working = part.part->cam.working;
    for (std::size_t row = 0; row < working.size(); ++row) {
        double arm = readings.front()->arms_mm[row];
        for (const readback::ArmError* reading : readings)
            arm = std::isnan(reading->arms_mm[row]) ? reading->arms_mm[row] : std::max(arm, reading->arms_mm[row]);
        arms.push_back({working[row].arm.angle, core::m_from_mm(arm)});
    }
    return arms;
}

/// Largest |torque/nominal - 1| over the travel that both have.
double worst_law(const spring::Potential& found, const spring::Potential& nominal) {
    const double end = std::min(found.domain().high, nominal.domain().high);
    double worst = 0.0;
    for (int i = 0; i <= kPlaces; ++i) {
        const double x = end * i / kPlaces;
        worst = std::max(worst, std::abs(found.force(x) / nominal.force(x) - 1.0));
    }
    return worst;
}

/// Compares the joints of all formats with the nominal one.
class Comparison {
public:
    explicit Comparison(const ResolvedDesign& design)
        : design_(design), nominal_{spring::series_spring(design.law()), spring::parallel_spring(design.law())} {
        const profile::Rig& rig = design.profile.rig;
        result_.torques = {rig.least_torque, rig.peak_torque, rig.overdrive_torque};
        result_.nominal = dead_bands(design.law());
    }

    void add(const Format& format) {
        if (!format.mirror_of.empty() && add_image(format)) return;
        JointAsExported joint;
        joint.reader = format.reader;
        joint.dead_band.assign(result_.torques.size(), std::nan(""));
        std::array<spring::PotentialPtr, 2> springs = nominal_;
        for (const std::size_t part : {0, 1}) {
            const auto& readings = format.readings[part];
            if (readings.empty()) continue;
            ExportedSpring& spring = part == 0 ? joint.series : joint.parallel;
            spring.file = readings.front()->file;
            for (const readback::ArmError* reading : readings) {
                if (!(reading->worst_relative <= spring.worst_arm)) spring.worst_arm = reading->worst_relative;
                joint.binding = joint.binding && reading->when_broken == core::Severity::kError;
            }
            springs[part] = spring_of(*format.parts[part], readings, joint);
            if (!springs[part]) break;
            spring.worst_law = worst_law(*springs[part], *nominal_[part]);
        }
        if (joint.refusal.empty()) couple(springs, joint);
        result_.joints.push_back(std::move(joint));
    }

    [[nodiscard]] AsExported done() && { return std::move(result_); }

private:
    /// The joint of mirror images is the one of the files that were read. @returns false if that joint has other parts
    [[nodiscard]] bool add_image(const Format& format) {
        const auto file = [&](std::size_t part, const std::string& ending) {
            return format.readings[part].empty() ? "" : cam::to_string(format.parts[part]->part->cam.kind) + ending;
        };
        const std::string series = file(0, format.mirror_of), parallel = file(1, format.mirror_of);
        const auto same = std::find_if(result_.joints.begin(), result_.joints.end(), [&](const JointAsExported& joint) {
            return joint.reader == format.reader && joint.series.file == series && joint.parallel.file == parallel;
        });
        if (same == result_.joints.end() || !same->refusal.empty()) return false;
        JointAsExported joint = *same;
        joint.series.file = file(0, format.ending);
        joint.parallel.file = file(1, format.ending);
        result_.joints.push_back(std::move(joint));
        return true;
    }

    [[nodiscard]] std::vector<double> dead_bands(const spring::SpringLawPtr& law) const {
        actuator::Actuator joint = design_.actuator;
        joint.law = law;
        return core::each<double>(result_.torques, [&](const double tau) { return actuator::dead_band(joint, tau).exact_width; });
    }

    /// None, and the joint's refusal, if no cable can be laid.
    [[nodiscard]] spring::PotentialPtr spring_of(const PartReport& part, const std::vector<const readback::ArmError*>& readings,
                                                 JointAsExported& joint) const {
        const cam::PartKind kind = part.part->cam.kind;
        const profile::PartSpec& spec = design_.spec(kind);
        const std::vector<cam::FoundArm> arms = found_arms(part, readings);
        const auto lost =
            std::find_if(arms.begin(), arms.end(), [&](const auto& row) { return !(row.arm + spec.allowance.on_arms() > 0.0); });
        if (lost == arms.end()) return cam::spring_of_arms(kind, arms, part.spring, design_.actuator.capstan_radius, spec.allowance);
        joint.refusal =
            fmt::format("{} has no arm for the cable at cam angle {:.1f} deg", readings.front()->file, core::deg_from_rad(lost->angle));
        return nullptr;
    }

    void couple(const std::array<spring::PotentialPtr, 2>& springs, JointAsExported& joint) const {
        const auto series = spring::continued(springs[0], kBeyond), parallel = spring::continued(springs[1], kBeyond);
        const double low = std::max(series->domain().low, parallel->domain().low);
        const double high = std::min(series->domain().high, parallel->domain().high);
        const auto law = spring::make_pair_law(series, parallel, series->force(low) + parallel->force(low),
                                               kToTheEnd * (series->force(high) + parallel->force(high)));
        if (law)
            joint.dead_band = dead_bands(*law);
        else
            joint.refusal = law.refusal().front().what + ", " + law.refusal().front().where;
    }

    const ResolvedDesign& design_;
    std::array<spring::PotentialPtr, 2> nominal_;
    AsExported result_;
};

}  // namespace

AsExported as_exported(const ResolvedDesign& design, const DesignReport& parts) {
    Comparison comparison(design);
    for (const Format& format : formats(parts)) comparison.add(format);
    return std::move(comparison).done();
}

}  // namespace fusee::pipeline
