#pragma once
#include <string>

namespace fusee::core {

/// A function of a shared library that is loaded when it is first needed, so that a start of the program does not wait for large libraries.
/// The library is searched beside the program (or beside Python's module), in the library folder of their prefix or build, and where it was
/// installed; it stays loaded. Thread-safe.
/// @param library its file name: "fusee_nsga2.so" @param function its name with C linkage @throws IoError naming the library, with the
/// linker's reasons
[[nodiscard]] void* loaded_function(const std::string& library, const char* function);

}  // namespace fusee::core
