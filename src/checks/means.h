#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fusee/checks/limits.h"
#include "fusee/core/units.h"
#include "fusee/spring/coil.h"
#include "measure.h"
#include "needs.h"
#include "shape.h"
#include "spring_form.h"

// The one header that a rule's file includes.
