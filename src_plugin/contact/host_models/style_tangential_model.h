// SPDX-License-Identifier: GPL-2.0-only
#include "tangential_model_history.h"
