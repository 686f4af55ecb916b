#pragma once
#include <vector>

#include "fusee/search/init.h"

namespace fusee::search::init {

/// Work and preload of both springs, and the springs that hold them. @pre a measured law is a pair of springs
[[nodiscard]] std::vector<Store> stores_of(const Answers& answers, const spring::Catalogue& catalogue);

/// "init.energy" for each spring that no wire can hold; empty: none.
[[nodiscard]] core::Findings not_held(const std::vector<Store>& stores);

}  // namespace fusee::search::init
