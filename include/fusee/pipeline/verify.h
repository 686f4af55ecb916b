#pragma once
#include "fusee/pipeline/make.h"

namespace fusee::pipeline {

/// `make` in a folder that is gone afterwards: whether every file of a design carries its law. @throws as make
[[nodiscard]] MakeResult make_to_verify(const profile::Profile& profile);

}  // namespace fusee::pipeline
