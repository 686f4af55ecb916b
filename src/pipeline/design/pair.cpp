#include "fusee/pipeline/pair.h"

#include <utility>

#include "fusee/solid/part.h"

namespace fusee::pipeline {

Pair pair_of(DesignedPart agonist, bool both) {
    Pair pair{std::make_shared<const DesignedPart>(std::move(agonist)), nullptr};
    if (both) pair.antagonist = std::make_shared<const DesignedPart>(DesignedPart{solid::mirrored(pair.agonist->part), {}});
    return pair;
}

spring::BaseSpring mirrored(spring::BaseSpring spring) {
    if (spring.hand != spring::Hand::kUnknown)
        spring.hand = spring.hand == spring::Hand::kRight ? spring::Hand::kLeft : spring::Hand::kRight;
    return spring;
}

}  // namespace fusee::pipeline
