#pragma once
#include <cmath>
#include <string>

#include "fusee/coupon/calibration.h"

namespace fusee::coupon {

inline Figure make_figure(std::string id, std::string what, std::string key, std::string unit, double per_unit, std::size_t rows) {
    Figure f;
    f.id = std::move(id);
    f.what = std::move(what);
    f.key = std::move(key);
    f.unit = std::move(unit);
    f.per_unit = per_unit;
    f.rows = rows;
    return f;
}

/// The profile's value of the figure's key; a compensation that it does not state is 0.
inline void set_present(Figure& f, const Present& present) {
    if (const auto known = present.find(f.key); known != present.end()) f.present = known->second;
    if (std::isnan(f.present) && f.key.starts_with("compensation.")) f.present = 0.0;
}

inline void set_estimate(Figure& f, const Estimate& estimate) {
    f.value = estimate.value;
    f.range = estimate.interval();
}

}  // namespace fusee::coupon
