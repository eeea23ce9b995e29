#include "tangential_model_history.h"
