#pragma once
#include "fusee/gap/effect.h"
