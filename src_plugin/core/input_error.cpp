#include "core/input_error.h"

#include <sstream>

namespace encased_column {

std::string in_words(double x)
{
  std::ostringstream text;
  text << x;
  return text.str();
}

}  // namespace encased_column
