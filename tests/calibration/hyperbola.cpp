// SPDX-License-Identifier: GPL-2.0-only
// A program in place of a test, as a user may have one: hyperbola LOG NAME=VALUE ... adds a line to
// LOG, waits a moment and writes q = strain / (1 / stiffness + strain / strength) to curve.csv,
// with the variables `stiffness` [Pa] and `strength` [Pa]. It fails where `strength` is above 900
// kPa.
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <thread>

int main(int count, char** words)
{
  double stiffness = 20e6, strength = 300e3;
  for (int n = 2; n < count; ++n) {
    const char* sign = std::strchr(words[n], '=');
    const std::string name(words[n], sign ? static_cast<std::size_t>(sign - words[n]) : 0);
    if (name == "stiffness") stiffness = std::atof(sign + 1);
    if (name == "strength") strength = std::atof(sign + 1);
  }
  std::ofstream(words[1], std::ios::app) << "started\n";
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  if (strength > 900e3) return 3;
  std::ofstream curve("curve.csv");
  curve << "axial_strain [-],deviatoric_stress [Pa]\n";
  for (int n = 0; n <= 100; ++n) {
    const double strain = 0.2 * n / 100.0;
    curve << strain << ',' << strain / (1.0 / stiffness + strain / strength) << '\n';
  }
}
