#include "core/input_error.h"

#include <sstream>

namespace encased_column {

std::string in_words(double x)
{
  std::ostringstream text;
  text << x;
  return text.str();
}

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

}  // namespace encased_column
