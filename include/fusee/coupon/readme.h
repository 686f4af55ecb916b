#pragma once
#include <string>

#include "fusee/coupon/sheet.h"

namespace fusee::coupon {

/// README.md of a folder of coupons: what lies there, how to make it, what to measure for each row of the sheet.
[[nodiscard]] std::string readme(const Drawn& drawn, const std::string& provenance);

}  // namespace fusee::coupon
