#include <filesystem>
#include <system_error>

#include "bindings.h"
#include "fusee/core/error.h"
#include "fusee/core/progress.h"

namespace fusee::python {

namespace {

py::object exception(const char* name) { return py::module_::import("fusee.errors").attr(name); }

py::object exception_of(const core::InvalidInput& e) { return exception("InvalidInput")(e.what(), e.field(), e.value(), e.allowed()); }

void raise(const py::object& error) { PyErr_SetObject(py::type::of(error).ptr(), error.ptr()); }

void raise_all(const core::InvalidInputs& e) {
    py::list all;
    for (const core::InvalidInput& one : e.all()) all.append(exception_of(one));
    const core::InvalidInput& first = e.all().front();
    raise(exception("InvalidInput")(e.what(), first.field(), first.value(), first.allowed(), py::tuple(all)));
}

void translate(std::exception_ptr thrown) {
    try {
        if (thrown) std::rethrow_exception(thrown);
    } catch (const core::InvalidInput& e) {
        raise(exception_of(e));
    } catch (const core::InvalidInputs& e) {
        raise_all(e);
    } catch (const core::IoError& e) {
        raise(exception("IoError")(e.what()));
    } catch (const std::system_error& e) {  // a full disk, a folder that is a file, no more threads
        raise(exception("IoError")(e.code().value(), e.what()));
    } catch (const core::Stopped&) {
        PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
}

}  // namespace

void bind_errors(py::module_&) { py::register_exception_translator(translate); }

}  // namespace fusee::python
