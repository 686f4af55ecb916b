#include "rig/gap_map.h"

#include "fusee/core/error.h"
#include "fusee/report/diagnosis.h"
#include "fusee/report/picture.h"

namespace fusee::report {

std::string gap_map_picture(const diagnosis::Diagnosis& diagnosis, Theme theme) {
    const std::vector<Figure> figures = gap_map_figures(diagnosis.map);
    if (figures.empty()) throw core::InvalidInput("--view", kGapMapView, "a case with measured rows: the diagnosis of this one has no map");
    return standalone(figures, theme);
}

}  // namespace fusee::report
