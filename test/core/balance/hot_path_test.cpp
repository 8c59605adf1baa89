// SPDX-License-Identifier: BSD-3-Clause
// Requirement of a co-simulation at 1 kHz: with a fixed grid and one patch per wheel, an evaluation allocates no
// memory.
#include "../allocation_counter.h"
#include "wheelset_scene.h"

#ifdef __GLIBC__
namespace wheel_rail_contact::core
{
namespace
{
void sweep(WheelsetContact& contact, double yaw)
{
  for (int k = -80; k <= 80; ++k)
  {
    WheelsetState state = stateAt(k * 0.05e-3, 1e5, yaw);
    state.motion.speed = 20;
    ASSERT_TRUE(isUsable(contact.evaluate(state).status)) << "y = " << state.y;
  }
}

long allocationsOnThirdSweep(const ContactModelConfig& config, double yaw = 0)
{
  WheelsetContact contact(config);
  sweep(contact, yaw);
  sweep(contact, yaw);  // includes the jump back from one end to the other
  return allocationsOf([&] { sweep(contact, yaw); });
}

ContactModelConfig onOneGrid()
{
  ContactModelConfig config = manchesterScene();
  config.contact.method = NormalMethod::conjugate_gradient;
  return config;
}

TEST(HotPath, StiffOrBendingRailsYawAndStressAllocateNothing)
{
  ContactModelConfig with_stress = onOneGrid(), bending = onOneGrid();
  with_stress.stress.depths = 16;
  bend(bending, softPads());
  EXPECT_EQ(allocationsOnThirdSweep(onOneGrid()), 0);
  EXPECT_EQ(allocationsOnThirdSweep(onOneGrid(), 0.005), 0);
  EXPECT_EQ(allocationsOnThirdSweep(with_stress, 0.005), 0);
  EXPECT_EQ(allocationsOnThirdSweep(bending), 0);
}

// Grids without symmetry are prepared in advance, too. The first yawed message allocates only memory for twice the
// cells.
TEST(HotPath, FirstYawedMessagesComputeNoCoefficients)
{
  WheelsetContact contact(onOneGrid());
  sweep(contact, 0);
  // One set of coefficients takes more allocations than this: tables of the rows and columns of the grid, spectrum,
  // factors.
  allocationsOf([&] { sweep(contact, 0.005); });
  EXPECT_LE(allocations, 40);
}

TEST(HotPath, FrictionAllocatesNothing)
{
  ContactModelConfig config = manchesterScene();
  config.contact.cells_along = 12;
  config.contact.cells_across = 24;
  for (const CreepMethod method : {CreepMethod::linear, CreepMethod::fastsim, CreepMethod::exact})
  {
    config.creep.method = method;
    EXPECT_EQ(allocationsOnThirdSweep(config), 0) << toString(method);
  }
}
}  // namespace
}  // namespace wheel_rail_contact::core
#endif
