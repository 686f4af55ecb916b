#pragma once

#include "fusee/core/finding.h"
#include "fusee/core/units.h"
#include "fusee/search/init.h"
#include "fusee/spring/law.h"

namespace fusee::search::init {

/// The measured springs where both are springs: the longest run of angles over which torques and stiffnesses of both stay above 0.
class MeasuredLaw {
public:
    /// Refusal: "law.stiffness" with the least stiffness and its angle, if less than a twentieth of the file's angles is such a run.
    static core::Outcome<MeasuredLaw> of(const profile::TablePair& rows);

    /// What a profile may ask for: the law's ends, less the rounding of the profile's numbers [Nm].
    [[nodiscard]] core::Range loads() const { return {law_->loads().low / kUsed, kUsed * law_->loads().high}; }
    /// Of the file [rad].
    [[nodiscard]] core::Range angles() const { return {first_angle_, first_angle_ + law_->angles().high}; }

    /// What the answers ask of the law: its points at the dead-band's edges, at the lower one of the least co-contraction and the upper one
    /// of the greatest (docs/theory/dead_band.md); beyond its ends the law goes on with its stiffness there.
    struct Asked {
        core::Range loads;   ///< [Nm]; NaN where the balance has no solution
        core::Range angles;  ///< of the file [rad]
    };
    [[nodiscard]] Asked asked(const Answers& answers) const;
    /// "cover.least", "cover.greatest": the ends that the springs do not reach; empty: none.
    [[nodiscard]] core::Findings missing(const Answers& answers) const;

private:
    MeasuredLaw(spring::SpringLawPtr law, double first_angle) : law_(std::move(law)), first_angle_(first_angle) {}
    [[nodiscard]] double load_at(double theta) const;

    static constexpr double kUsed = 0.9995;
    spring::SpringLawPtr law_;
    double first_angle_;  ///< of the file, where the law begins [rad]
};

}  // namespace fusee::search::init
