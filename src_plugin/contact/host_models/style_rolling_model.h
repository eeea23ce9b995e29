// SPDX-License-Identifier: GPL-2.0-only
#include "rolling_model_epsd2.h"
