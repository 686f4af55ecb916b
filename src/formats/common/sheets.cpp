#include "common/sheets.h"

namespace fusee::formats {

const std::vector<drawing::Sheet>& sheets_of(PartExport& out) {
    if (!out.sheets) out.sheets = drawing::draw(subject_of(out));
    return *out.sheets;
}

drawing::Subject subject_of(const PartExport& out) {
    const Settings& settings = out.settings;
    return {out.part, out.spring, settings.cable, settings.process, settings.design, out.name(), out.provenance.line(), settings.title};
}

}  // namespace fusee::formats
