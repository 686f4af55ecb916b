#include "failure.h"

#include <fmt/format.h>

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <Standard_Type.hxx>
#include <new>

namespace fusee::exchange::brep {

void guard(const std::function<void()>& work) {
    try {
        work();
    } catch (const Standard_OutOfMemory&) {
        throw std::bad_alloc();
    } catch (const Standard_Failure& e) {
        const char* words = e.GetMessageString();
        throw Failure(fmt::format("OpenCASCADE: {}{}{}", e.DynamicType()->Name(), words && *words ? ": " : "", words ? words : ""));
    }
}

}  // namespace fusee::exchange::brep
