#pragma once

namespace fusee::python {

/// The comment of a header, "spring::LawPoint::tau", as a docstring. The build refuses a name without comment (tools/docstrings.py).
[[nodiscard]] const char* doc(const char* name);

}  // namespace fusee::python
