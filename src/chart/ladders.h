// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <tuple>

#include "contender.h"
#include "wheel_rail_contact/balance/method_ladder.h"

namespace wheel_rail_contact::chart
{
/// Solvers by choice, each made once: preparing one costs more than many solutions.
class Ladders
{
 public:
  const MethodLadder& find(const Choice& choice);

 private:
  std::map<std::tuple<NormalMethod, int, int, double>, std::unique_ptr<MethodLadder>> ladders_;
};
}  // namespace wheel_rail_contact::chart
