// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/held_contact.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace simulate_wheelset
{
namespace
{
/// Contact with a prescribed usability in each call; the height counts the calls.
class Prescribed : public ContactSource
{
 public:
  explicit Prescribed(std::vector<bool> usable) : usable_(std::move(usable)) {}

  double rollingRadius() const override { return 0.46; }
  ContactReply evaluate(const ContactRequest& /*request*/) override
  {
    ContactReply reply;
    reply.is_usable = usable_.at(calls_++);
    reply.status = "beyond the end of a profile";
    reply.z = static_cast<double>(calls_);
    return reply;
  }

 private:
  std::vector<bool> usable_;
  std::size_t calls_ = 0;
};

TEST(HeldContact, LastUsableContactIsHeldAndCounted)
{
  Prescribed source({true, false, false, true, false, false});
  HeldContact contact(source, 2);
  const std::vector<double> heights = {1, 1, 1, 4, 4, 4};
  const std::vector<bool> held = {false, true, true, false, true, true};
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    EXPECT_EQ(contact.evaluate({}).z, heights[i]);
    EXPECT_EQ(contact.isHeld(), held[i]);
  }
  EXPECT_EQ(contact.held(), 4);
}

TEST(HeldContact, TooManySuccessiveStepsStopWithTheReason)
{
  Prescribed source({true, false, false, false});
  HeldContact contact(source, 2);
  for (int i = 0; i < 3; ++i)
  {
    contact.evaluate({});
  }
  try
  {
    contact.evaluate({});
    FAIL() << "no exception";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_STREQ(
        error.what(),
        "no usable contact in 3 successive steps, at 0.000000 s, y = 0.000000 mm: beyond the end of a profile");
  }
}

TEST(HeldContact, FirstStepMustBeUsable)
{
  Prescribed source({false});
  HeldContact contact(source, 5);
  EXPECT_THROW(contact.evaluate({}), std::runtime_error);
}
}  // namespace
}  // namespace simulate_wheelset
