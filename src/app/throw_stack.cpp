// Notes where an exception was thrown that is a fault of fusee: the report of an internal error shows the stack (fusee/core/crash_report.h).
// The program's __cxa_throw comes before that of the C++ library, which it calls.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define FUSEE_SANITIZED  // they have their own __cxa_throw
#endif
#endif

#ifndef FUSEE_SANITIZED
#include <dlfcn.h>

#include <cstdlib>
#include <string_view>
#include <typeinfo>

#include "fusee/core/crash_report.h"
#include "fusee/core/error.h"
#include "fusee/core/progress.h"

extern "C" [[noreturn]] void __cxa_throw(void* thrown, void* type_info, void (*destructor)(void*)) {  // NOLINT: the ABI's name; g++ declares it so
    using Throw = void (*)(void*, void*, void (*)(void*));
    static const auto next = reinterpret_cast<Throw>(::dlsym(RTLD_NEXT, "__cxa_throw"));
    namespace core = fusee::core;
    const auto* type = static_cast<const std::type_info*>(type_info);
    const bool refusal = *type == typeid(core::InvalidInput) || *type == typeid(core::InvalidInputs) || *type == typeid(core::IoError) ||
                         *type == typeid(core::InputError) || *type == typeid(core::Stopped);
    // CGAL throws where a comparison in floating point is not certain, and compares again exactly.
    const bool of_cgal = std::string_view(type->name()).starts_with("N4CGAL");
    if (!refusal && !of_cgal) core::note_throw(type->name());
    next(thrown, type_info, destructor);
    std::abort();
}
#endif
