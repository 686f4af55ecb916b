#include "common/sheets.h"

#include "fusee/drawing/drawing.h"

namespace fusee::formats {

const std::vector<drawing::Sheet>& sheets_of(PartExport& out) {
    const Settings& settings = out.settings;
    if (!out.sheets)
        out.sheets =
            drawing::draw({out.part, out.spring, settings.cable, settings.process, settings.design, out.name(), out.provenance.line()});
    return *out.sheets;
}

}  // namespace fusee::formats
