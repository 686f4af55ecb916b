#include "docs.h"

#include <stdexcept>
#include <string>
#include <string_view>

namespace fusee::python {

namespace {

struct Docstring {
    std::string_view name;
    const char* text;
};
#include "docstrings.inc"

}  // namespace

const char* doc(const char* name) {
    for (const Docstring& row : kDocstrings)
        if (row.name == name) return row.text;
    throw std::logic_error(std::string("no docstring for ") + name);
}

}  // namespace fusee::python
