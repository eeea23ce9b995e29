// SPDX-License-Identifier: GPL-2.0-only
// A packing on two ranks whose grains change places, lists and ranks, with the weight that `fix
// motion` takes over and with the host's.
#include "restart/specimen_deck.h"

#include <gtest/gtest.h>

using namespace encased_column::testing;

namespace {

Outcome packed(const std::string& gravity)
{
  std::string deck = new_specimen(
      "run 1000\nunfix grow\nneighbor 0.00005 bin\nrun 1000\n"
      "variable top equal f_top[1]\nprint \"top ${top}\"\n"
      "variable bottom equal f_bottom[1]\nprint \"bottom ${bottom}\"\n"
      "variable loss equal f_move[5]\nprint \"loss ${loss}\"\n");
  const std::string plain = "gravity 9.8";
  return run_deck("variable g equal 9.8\n" + deck.replace(deck.find(plain), plain.size(), gravity),
                  2);
}

}  // namespace

TEST(Weight, OfAPackingIsTheHosts)
{
  const Outcome ours = packed("gravity 9.8"), host = packed("gravity v_g");
  ASSERT_EQ(ours.exit_code, 0) << ours.output;
  ASSERT_EQ(host.exit_code, 0) << host.output;
  EXPECT_GT(ours.value("bottom"), 1e3);
  for (const char* number : {"top", "bottom", "loss"})
    EXPECT_NEAR(ours.value(number), host.value(number), 1e-5 * host.value(number)) << number;
}
