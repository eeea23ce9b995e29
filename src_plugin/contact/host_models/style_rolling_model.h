#include "rolling_model_epsd2.h"
