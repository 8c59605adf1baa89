// SPDX-License-Identifier: BSD-3-Clause
// Fields of a result that are the same in the core, in the message, in the table of a replay and in Python.
//
// Each function calls visit(ResultField, core, message) for the fields of one type, in the order of the table. `core`
// gives the value from an object of the core, `message` from a message. Axes and signs are those of the message.
#pragma once

namespace wheel_rail_contact
{
/// A field: its name, and what it is.
struct ResultField
{
  const char* name;  ///< as in the message
  const char* unit;  ///< "-" for a number without a unit; empty for a text
  const char* text;  ///< meaning, in a few words
};

// Arguments of visit() for a field with a name, and with the name of the member of the core if it is another one.
#define MEMBER(name) ([](auto& object) -> auto& { return object.name; })
#define FIELD_OF(core_name, name, unit, text) ResultField{#name, unit, text}, MEMBER(core_name), MEMBER(name)
#define FIELD(name, unit, text) FIELD_OF(name, name, unit, text)

/// Fields of a patch, without side, pose, pressure and stresses.
template <typename Visit>
void visitPatch(const Visit& visit)
{
  visit(FIELD(contact_angle, "rad", "angle to the track plane, positive where the wheel presses the rail outward"));
  visit(FIELD(normal_force, "N", "resultant of the pressure"));
  visit(FIELD(approach, "m", "approach along the normal, from first touch"));
  visit(FIELD(area, "m^2", "contact area"));
  visit(FIELD(max_pressure, "Pa", "highest pressure, found between the cells"));
  visit(FIELD(error_estimate, "-", "largest estimated relative error of max_pressure, area and approach"));
  visit(FIELD(iterations, "-", "number of products with the influence matrix"));
  visit(FIELD(residual, "-", "largest violation of the contact conditions, relative"));
  visit(FIELD(method, "", "method that solved the patch"));
  visit(FIELD(half_space_ratio, "rad", "half the angle by which the section turns across the patch"));
  visit(FIELD(model_error, "-",
              "bound of the relative error of max_pressure and area because of the half-spaces; 1: not known"));
  visit(FIELD(vertical_force, "N", "Q, of normal pressure and friction, on the rail, down positive"));
  visit(FIELD(lateral_force, "N", "Y, of normal pressure and friction, on the rail, outward positive"));
  visit(FIELD(semi_axis_along, "m", "of the equivalent ellipse, along x"));
  visit(FIELD(semi_axis_across, "m", "of the equivalent ellipse, along y"));
  visit(FIELD(rolling_radius, "m", "of the centre of pressure, from the axle"));
  visit(FIELD(wheel_s, "m", "arc length on the wheel profile, outward positive"));
  visit(FIELD(wheel_angle, "rad", "place around the wheel, forward positive"));
  visit(FIELD(rail_s, "m", "arc length on the rail profile, outward positive"));
  visit(FIELD(slope_along, "-", "slope of the rail along the track, in the patch frame, upward positive"));
  visit(FIELD(curvature_along, "1/m", "combined, along x, convex positive"));
  visit(FIELD(curvature_across, "1/m", "combined, across, convex positive"));
  visit(FIELD(normal_stiffness, "N/m", "normal force per approach"));
}

/// Fields of the friction of a patch, without its tractions.
template <typename Visit>
void visitCreep(const Visit& visit)
{
  visit(FIELD_OF(creepage.x, creepage_x, "-", "velocity of the wheel relative to the rail along x, over the speed"));
  visit(FIELD_OF(creepage.y, creepage_y, "-", "the same along y"));
  visit(FIELD_OF(creepage.spin, spin, "1/m", "rotation of the wheel about z over the speed"));
  visit(FIELD_OF(force.x, force_x, "N", "friction of the rail on the wheel along x"));
  visit(FIELD_OF(force.y, force_y, "N", "the same along y"));
  visit(FIELD_OF(force.moment, moment, "N m", "the same about z"));
  visit(FIELD(vertical_force, "N", "part of vertical_force of the patch by friction"));
  visit(FIELD(lateral_force, "N", "part of lateral_force of the patch by friction"));
  visit(FIELD(adhesion_share, "-", "resultant of force_x and force_y over the friction limit"));
  visit(FIELD(power, "W", "power dissipated by friction"));
  visit(FIELD(error_estimate, "-", "estimated error of the forces over the friction limit"));
}

/// Numbers of a pressure grid.
template <typename Visit>
void visitGrid(const Visit& visit)
{
  visit(FIELD(nx, "-", "number of cells along x"));
  visit(FIELD(ny, "-", "number of cells along y"));
  visit(FIELD(dx, "m", "length of a cell along the track"));
  visit(FIELD(dy, "m", "width of a cell across the track"));
  visit(FIELD(x0, "m", "x of the centre of the first cell"));
  visit(FIELD(y0, "m", "y of the centre of the first cell"));
}

/// Fields of a highest stress.
template <typename Visit>
void visitPeak(const Visit& visit)
{
  visit(FIELD(value, "Pa", "the stress"));
  visit(FIELD(x, "m", "along the track, forward, in the patch frame"));
  visit(FIELD(y, "m", "across the track, left, along the arc of the rail's section"));
  visit(FIELD(depth, "m", "below the surface, along its normal"));
}

/// Numbers of the stress beneath a patch, without the peaks and the field.
template <typename Visit>
void visitStress(const Visit& visit)
{
  visit(FIELD(load_factor, "-", "max_pressure over the yield stress in shear; 0 if the yield stress is not given"));
  visit(FIELD(shakedown_limit, "-", "load_factor above which the body cannot shake down to an elastic state"));
}

/// Fields of the forces of a wheel.
template <typename Visit>
void visitWheel(const Visit& visit)
{
  visit(FIELD_OF(vertical, vertical_force, "N", "Q, of normal pressure and friction, down positive"));
  visit(FIELD_OF(lateral, lateral_force, "N", "Y, of normal pressure and friction, outward positive"));
  visit(FIELD_OF(friction_vertical, friction_vertical_force, "N", "part of vertical_force by friction"));
  visit(FIELD_OF(friction_lateral, friction_lateral_force, "N", "part of lateral_force by friction"));
}

/// Fields of a rail.
template <typename Visit>
void visitRail(const Visit& visit)
{
  visit(FIELD_OF(deflection.lateral, lateral, "m", "displacement from the ideal track, outward positive"));
  visit(FIELD_OF(deflection.vertical, vertical, "m", "displacement from the ideal track, up positive"));
  visit(FIELD_OF(deflection.roll, roll, "rad", "rotation, positive if the crown moves outward"));
  visit(FIELD(lateral_force, "N", "lateral force that bends the rail, outward positive"));
  visit(FIELD(vertical_force, "N", "vertical force of the wheel, down positive"));
  visit(FIELD(moment, "N m", "moment of both about the reference point of the head, outward roll positive"));
  visit(FIELD_OF(given.lateral, given_lateral, "m", "part of lateral by the line and with the state"));
  visit(FIELD_OF(given.vertical, given_vertical, "m", "part of vertical by the line and with the state"));
  visit(FIELD_OF(given.roll, given_roll, "rad", "part of roll by the line and with the state"));
  visit(FIELD_OF(slope.lateral, lateral_slope, "-", "change of the lateral place along the track, outward positive"));
  visit(FIELD_OF(slope.vertical, vertical_slope, "-", "change of the vertical place along the track, up positive"));
  visit(FIELD_OF(slope.roll, roll_slope, "rad/m", "change of the roll along the track"));
}

#undef FIELD
#undef FIELD_OF
#undef MEMBER
}  // namespace wheel_rail_contact
