// SPDX-License-Identifier: GPL-2.0-only
// Models the host's templates are instantiated with here; the host's own lists are not shipped.
#include "surface_model_default.h"
