#pragma once
#include <string>
#include <vector>

#include "fusee/core/finding.h"
#include "fusee/formats/format.h"
#include "fusee/toolpath/mill.h"
#include "fusee/toolpath/program.h"

namespace fusee::formats {

/// One program in simulation.
struct Milled {
    std::string file;  ///< "k_se.ngc"
    toolpath::mill::Program program;
    toolpath::mill::Result result;
    core::Findings findings;
};

/// Simulates the programs of a part in their order: the blank's stock is that of the wrapped groove. Contacts are errors; so are
/// "millsim.gouge" and "millsim.excess", the stock against the drawn groove of a planar part.
[[nodiscard]] std::vector<Milled> mill(const PartExport& out, const std::vector<toolpath::Program>& programs);

/// The setup sheet of a program as Markdown: stock, zero, clamping, tools, operations with times, what is left by hand, checks.
[[nodiscard]] std::string setup_sheet(const Milled& milled, const PartExport& out);

}  // namespace fusee::formats
