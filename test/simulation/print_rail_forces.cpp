// SPDX-License-Identifier: BSD-3-Clause
// Creep forces of the C++ example, for comparison with those in Python (test_creep.py).
//
// Input, one case per line, numbers in SI units: Poisson's ratio, coefficient of friction, yaw, y', yaw', spin, roll,
// speed, number of contacts, and for each contact: 1 if it is left, x, y, z, angle, normal force, semi-axes a and b.
// Output, one line per case: creep force along y and z, its moments about x, z and the axle.
#include <iomanip>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>

#include "examples/simulate_wheelset/wheelset_dynamics.h"

namespace
{
using namespace simulate_wheelset;

ContactPoint readPoint(std::istream& in)
{
  ContactPoint p;
  in >> p.is_left >> p.position.x() >> p.position.y() >> p.position.z() >> p.angle >> p.normal_force >>
      p.semi_axis_along >> p.semi_axis_across;
  return p;
}

RailForces forcesOf(std::istream& in)
{
  CreepParameters creep;
  Motion motion;
  ContactReply contact;
  double speed = 0;
  int points = 0;
  in >> creep.poisson >> creep.friction >> motion.yaw >> motion.y_rate >> motion.yaw_rate >> motion.spin >>
      contact.roll >> speed >> points;
  for (int i = 0; i < points; ++i)
  {
    contact.points.push_back(readPoint(in));
  }
  return railForces(contact, motion, speed, CreepLaw(creep));
}
}  // namespace

int main()
{
  std::cout << std::setprecision(std::numeric_limits<double>::max_digits10);
  std::string line;
  while (std::getline(std::cin, line))
  {
    std::istringstream in(line);
    const RailForces forces = forcesOf(in);
    if (!in)
    {
      std::cerr << "not a case: " << line << '\n';
      return 1;
    }
    std::cout << forces.creep_force.y() << ' ' << forces.creep_force.z() << ' ' << forces.creep_moment.x() << ' '
              << forces.creep_moment.z() << ' ' << forces.spin_moment << '\n';
  }
  return 0;
}
