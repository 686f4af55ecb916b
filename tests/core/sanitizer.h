#pragma once

namespace fusee::core {

/// The tests run under the address sanitizer.
#if defined(__has_feature)
inline constexpr bool kAddressSanitizer = __has_feature(address_sanitizer);
#else
inline constexpr bool kAddressSanitizer = false;
#endif

}  // namespace fusee::core
