// libFuzzer's end of one reader: FUSEE_FUZZ_READER is its name (readers.cpp). docs/robustness.md says how to run it.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fusee::fuzz::Reader* const reader = fusee::fuzz::reader(FUSEE_FUZZ_READER);
    (void)fusee::fuzz::accepts(*reader, {reinterpret_cast<const char*>(data), size});
    return 0;
}
