#include "energy.h"

#include <algorithm>
#include <cmath>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "fusee/pipeline/design.h"
#include "fusee/pipeline/evaluate.h"
#include "fusee/spring/coil.h"
#include "search.h"

namespace fusee::search::init {

namespace {

// The largest springs that are tried for a first profile: as `fusee springs` winds them.
constexpr double kThickestWire_mm = 5.0, kWidestCoil = 40e-3, kMostCoils = 60.0, kLoosestIndex = 16.0;

/// Energy of a spring at its largest state or load [J].
double capacity(const spring::BaseSpring& s) {
    const double by_load = s.max_load > 0.0 ? s.max_load / s.rate : INFINITY, by_state = s.max_state > 0.0 ? s.max_state : INFINITY;
    const double state = std::min(by_load, by_state);
    return 0.5 * s.rate * state * state;
}

/// Energy of the largest spring that is wound of this wire [J].
double capacity_of_wire(spring::BaseKind kind, double wire) {
    spring::BaseSpring s;
    s.kind = kind;
    s.wire_diameter = wire;
    s.coil_diameter = std::min(kLoosestIndex * wire, kWidestCoil);
    s.active_coils = kMostCoils;
    s.wire_class = spring::WireClass::kSh;
    s.rate = spring::rate_of_coils(s);
    s.max_load = spring::allowed_share(s) * spring::tensile_strength(s) / spring::wire_stress(s, 1.0);
    return capacity(s);
}

}  // namespace

std::vector<Store> stores_of(const Answers& answers, const spring::Catalogue& catalogue) {
    const auto design = pipeline::resolve_for_search(scaled("init", answers, start_of(answers)));
    if (!design) return {};
    const spring::SpringLaw& law = *design->law();
    const spring::LawPoint low = law.at_load(design->design_loads.low), high = law.at_load(design->design_loads.high);
    std::vector<Store> stores;
    for (const cam::PartKind part : pipeline::kBothParts) {
        const bool series = part == cam::PartKind::kSeries;
        const spring::BaseSpring& wanted = design->spec(part).spring;
        Store store{part, series ? high.u_se - low.u_se : high.u_pe - low.u_pe, 0.5 * wanted.rate * wanted.preload * wanted.preload};
        for (const double mm : checks::wire_sizes().mm) {
            if (mm > kThickestWire_mm) break;
            store.largest = capacity_of_wire(wanted.kind, core::m_from_mm(mm));
            if (store.largest < store.energy()) continue;
            store.least_wire = core::m_from_mm(mm);
            break;
        }
        store.offered = catalogue.of(wanted.kind).size();
        for (const spring::CatalogueSpring& row : catalogue.of(wanted.kind))
            if (capacity(row.spring) >= store.energy()) store.bought.push_back(row.name);
        stores.push_back(std::move(store));
    }
    return stores;
}

core::Findings not_held(const std::vector<Store>& stores) {
    core::Findings findings;
    for (const Store& store : stores) {
        if (store.least_wire > 0.0) continue;
        core::Finding f =
            core::error_finding("init.energy", "work of the law and preload, against the largest spring that is wound: wire of 5 mm",
                                store.energy(), core::Bound::kAtMost, store.largest, "J");
        f.where = to_string(store.part);
        f.source = "docs/theory/coils.md, eq. 1-4";
        findings.push_back(std::move(f));
    }
    return findings;
}

}  // namespace fusee::search::init
