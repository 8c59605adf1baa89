// SPDX-License-Identifier: BSD-3-Clause
#include "examples/simulate_wheelset/motion_table.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace simulate_wheelset
{
namespace
{
constexpr int digits = 9;

/// Forces of one wheel.
struct Wheel
{
  double normal_force = 0;          ///< sum [N]
  double radius = 0;                ///< mean rolling radius, weighted with the normal forces [m]
  double creep_x = 0, creep_y = 0;  ///< creep force on the wheel along x and y of the track [N]
  double demand = 0;                ///< largest of the contacts [-]
  bool is_saturated = false;        ///< whether the creep force of a contact is at the friction limit
};

Wheel wheelOf(bool is_left, const ContactReply& contact, const RailForces& forces)
{
  Wheel wheel;
  for (std::size_t i = 0; i < contact.points.size(); ++i)
  {
    const ContactPoint& point = contact.points[i];
    if (point.is_left == is_left)
    {
      wheel.normal_force += point.normal_force;
      wheel.radius += point.normal_force * point.rolling_radius;
      wheel.creep_x += forces.creep[i].along;
      wheel.creep_y += forces.creep[i].across * std::cos(point.angle);
      wheel.demand = std::max(wheel.demand, forces.creep[i].demand);
      wheel.is_saturated = wheel.is_saturated || forces.creep[i].isSaturated();
    }
  }
  wheel.radius = wheel.normal_force > 0 ? wheel.radius / wheel.normal_force : std::nan("");
  return wheel;
}
}  // namespace

MotionTable::MotionTable(const std::string& file) : file_(file), stream_(file)
{
  stream_.precision(digits);
  stream_ << "time [s],distance [m],y [m],yaw [rad],y_rate [m/s],yaw_rate [rad/s],spin [rad/s],z [m],roll [rad],"
             "force_z [N],torque_x [N m],normal_force_y [N],creep_force_y [N],yaw_moment [N m],friction_power [W]";
  for (const char* side : {"left", "right"})
  {
    stream_ << ',' << side << "_normal_force [N]," << side << "_rolling_radius [m]," << side << "_creep_x [N]," << side
            << "_creep_y [N]," << side << "_demand [-]," << side << "_saturated [-]";
  }
  stream_ << ",held [-]\n";
  check();
}

void MotionTable::add(const ContactRequest& request, const Motion& motion, const ContactReply& contact,
                      const RailForces& forces, bool is_held)
{
  stream_ << 1e-9 * static_cast<double>(request.time);
  for (const double value : {request.distance, motion.y, motion.yaw, motion.y_rate, motion.yaw_rate, motion.spin,
                             contact.z, contact.roll, request.force_z, request.torque_x, forces.normal_force.y(),
                             forces.creep_force.y(), forces.moment().z(), forces.friction_power})
  {
    stream_ << ',' << value;
  }
  for (const bool is_left : {true, false})
  {
    const Wheel wheel = wheelOf(is_left, contact, forces);
    stream_ << ',' << wheel.normal_force << ',' << wheel.radius << ',' << wheel.creep_x << ',' << wheel.creep_y << ','
            << wheel.demand << ',' << (wheel.is_saturated ? 1 : 0);
  }
  stream_ << ',' << (is_held ? 1 : 0) << '\n';
  check();
}

void MotionTable::close()
{
  stream_.close();
  check();
}

void MotionTable::check()
{
  if (!stream_)
  {
    throw std::runtime_error(file_ + ": cannot be written");
  }
}
}  // namespace simulate_wheelset
