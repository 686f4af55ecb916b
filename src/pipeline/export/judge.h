#pragma once
#include "fusee/formats/format.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/export.h"

namespace fusee::pipeline {

using formats::PartExport;

/// "readback.arm" of one file. @param cam that the file must carry
[[nodiscard]] core::Finding judge_arm(const readback::ArmError& error, const cam::Cam& cam);

/// "readback.sliced" of a print: a warning, since the files are right.
[[nodiscard]] core::Finding judge_print(const readback::ArmError& error, const solid::Part& part);

/// "toolpath.process": warns if the part has G-code, was judged for another process, and rules of the mill object.
void judge_for_mill(PartExport& out, const profile::Profile& profile);

}  // namespace fusee::pipeline
