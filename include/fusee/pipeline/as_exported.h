#pragma once
#include "fusee/profile/profile.h"
#include "fusee/report/as_exported.h"
#include "fusee/report/report.h"
#include "fusee/spring/law.h"

namespace fusee::pipeline {

/// The law and the dead-band of the joint as exported: for each format and reader the springs that the arms found make of the base springs,
/// both parts' together where both have that format, else with the nominal law of the other. Of two half plates that share a groove the
/// cable lies on the higher one. A joint needs its files only: what the rules say does not enter.
/// @param law the nominal one @param design its parts and its plate as they were read back
[[nodiscard]] report::AsExported as_exported(const profile::Profile& profile, const spring::SpringLawPtr& law,
                                             const report::DesignReport& design);

}  // namespace fusee::pipeline
