// SPDX-License-Identifier: GPL-2.0-only
#include "input_errors/refusal.h"

using namespace encased_column::testing;

TEST(ContactLaw, RefusesANegativeModulus)
{
  expect_refused("two_grains", R"(
unfix modulus
fix   modulus all property/global contactModulus peratomtypepair 2 7e6 7e6 7e6 -7e6
run   1
)",
                 "'contactModulus' must be larger than 0 for every pair of types, found -7e+06 for "
                 "types 2 and 2, write for example 7e+06 there in 'fix modulus'");
}

TEST(ContactLaw, RefusesFrictionBelowZero)
{
  expect_refused("two_grains", R"(
unfix friction
fix   friction all property/global coefficientFriction peratomtypepair 2 -0.1 0.5 0.5 0.5
run   1
)",
                 "'coefficientFriction' must be at least 0 for every pair of types, found -0.1 for "
                 "types 1 and 1, write for example 0.1 there in 'fix friction'");
}

TEST(ContactLaw, RefusesAStiffnessRatioOfZero)
{
  expect_refused(
      "two_grains", R"(
unfix kappa
fix   kappa all property/global stiffnessRatio peratomtypepair 2 1 0 0 1
run   1
)",
      "'stiffnessRatio' must be larger than 0 for every pair of types, found 0 for types "
      "1 and 2, write for example 1 there in 'fix kappa'");
}

TEST(ContactLaw, RefusesADeckWithoutModulus)
{
  expect_refused(
      "two_grains", R"(
unfix modulus
run   1
)",
      "the linear contact law needs 'contactModulus', found none for pairs of types, write 'fix "
      "ID all property/global contactModulus peratomtypepair 2 ...' with 4 values");
}

TEST(ContactLaw, RefusesAMatrixThatIsNotSymmetric)
{
  expect_refused("two_grains", R"(
unfix modulus
fix   modulus all property/global contactModulus peratomtypepair 2 7e6 7e6 9e6 7e6
run   1
)",
                 "matrix must be symmetric");
}

// The host hands out a matrix in place of the pairs of types and does not check it.
TEST(ContactLaw, RefusesAMatrixThatIsNotSymmetricInTheHostsGeneralForm)
{
  expect_refused("two_grains", R"(
unfix modulus
fix   modulus all property/global contactModulus matrix 2 7e6 7e6 9e6 7e6
run   1
)",
                 "'contactModulus' must be symmetric, found 9e+06 for types 2 and 1 and 7e+06 the "
                 "other way round, write one value for both in 'fix modulus'");
}

TEST(ContactLaw, RefusesRollingResistanceWithoutItsCoefficient)
{
  expect_refused("two_grains", R"(
pair_style gran model linear tangential history rolling_friction epsd2
pair_coeff * *
run   1
)",
                 "the linear contact law needs 'coefficientRollingFriction'");
}

// The host takes it and finds no contact at all: grains pass through one another.
TEST(ContactLaw, RefusesNeighborMulti)
{
  expect_refused("two_grains", R"(
neighbor 0.0005 multi
run      1
)",
                 "'neighbor' must take the style 'bin', found 'multi', with which the host finds "
                 "no contacts, write for example 'neighbor 0.0005 bin'");
}
