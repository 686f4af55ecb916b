#pragma once
#include <string>

#include "fusee/core/error.h"

namespace fusee {

/// The field that a call names as the caller's mistake; "accepted" if it finds none.
template <class Call>
std::string field_refused(const Call& call) {
    try {
        (void)call();
    } catch (const core::InvalidInput& error) {
        return error.field();
    }
    return "accepted";
}

}  // namespace fusee
