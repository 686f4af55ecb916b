#pragma once
#include <string>

#include "fusee/coupon/sheet.h"

namespace fusee::coupon {

/// README.md of a folder of coupons: its files, how to make the coupons, and what to measure for each row of the sheet.
[[nodiscard]] std::string readme(const Drawn& drawn, const std::string& provenance);

}  // namespace fusee::coupon
