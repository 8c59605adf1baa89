// SPDX-License-Identifier: BSD-3-Clause
// Fields of a result that are the same in the core, in the message, in the table of a replay and in Python.
//
// Each function calls visit(ResultField, core, message) for the fields of one type, in the order of the table. `core`
// and `message` give the value from an object of either type by std::invoke(). Axes and signs are those of the message.
#pragma once

#include <wheel_rail_contact/WheelsetContact.h>
#include "wheel_rail_contact/core/wheelset_result.h"

namespace wheel_rail_contact
{
/// A field: its name, and what it is.
struct ResultField
{
  const char* name;  ///< as in the message
  const char* unit;  ///< "-" for a number without a unit; empty for a text
  const char* text;  ///< meaning, in a few words
};

/// Fields of a patch, without side, pose, pressure and stresses.
template <typename Visit>
void visitPatch(const Visit& visit)
{
  using Core = core::PatchResult;
  using Message = ContactPatch;
  visit({"contact_angle", "rad", "angle to the track plane, positive where the wheel presses the rail outward"},
        &Core::contact_angle, &Message::contact_angle);
  visit({"normal_force", "N", "resultant of the pressure"}, &Core::normal_force, &Message::normal_force);
  visit({"approach", "m", "approach along the normal, from first touch"}, &Core::approach, &Message::approach);
  visit({"area", "m^2", "contact area"}, &Core::area, &Message::area);
  visit({"max_pressure", "Pa", "highest pressure, found between the cells"}, &Core::max_pressure,
        &Message::max_pressure);
  visit({"error_estimate", "-", "largest estimated relative error of max_pressure, area and approach"},
        &Core::error_estimate, &Message::error_estimate);
  visit({"iterations", "-", "number of products with the influence matrix"}, &Core::iterations, &Message::iterations);
  visit({"residual", "-", "largest violation of the contact conditions, relative"}, &Core::residual,
        &Message::residual);
  visit({"method", "", "method that solved the patch"}, &Core::method, &Message::method);
  visit({"half_space_ratio", "rad", "half the angle by which the section turns across the patch"},
        &Core::half_space_ratio, &Message::half_space_ratio);
  visit({"model_error", "-",
         "bound of the relative error of max_pressure and area because of the half-spaces; 1: not known"},
        &Core::model_error, &Message::model_error);
  visit({"vertical_force", "N", "part Q of normal_force on the rail, down positive"}, &Core::vertical_force,
        &Message::vertical_force);
  visit({"lateral_force", "N", "part Y of normal_force on the rail, outward positive"}, &Core::lateral_force,
        &Message::lateral_force);
  visit({"semi_axis_along", "m", "of the equivalent ellipse, along x"}, &Core::semi_axis_along,
        &Message::semi_axis_along);
  visit({"semi_axis_across", "m", "of the equivalent ellipse, along y"}, &Core::semi_axis_across,
        &Message::semi_axis_across);
  visit({"rolling_radius", "m", "of the centre of pressure, from the axle"}, &Core::rolling_radius,
        &Message::rolling_radius);
  visit({"wheel_s", "m", "arc length on the wheel profile, outward positive"}, &Core::wheel_s, &Message::wheel_s);
  visit({"wheel_angle", "rad", "place around the wheel, forward positive"}, &Core::wheel_angle, &Message::wheel_angle);
  visit({"rail_s", "m", "arc length on the rail profile, outward positive"}, &Core::rail_s, &Message::rail_s);
  visit({"curvature_along", "1/m", "combined, along x, convex positive"}, &Core::curvature_along,
        &Message::curvature_along);
  visit({"curvature_across", "1/m", "combined, across, convex positive"}, &Core::curvature_across,
        &Message::curvature_across);
  visit({"normal_stiffness", "N/m", "normal force per approach"}, &Core::normal_stiffness, &Message::normal_stiffness);
}

/// Numbers of a pressure grid.
template <typename Visit>
void visitGrid(const Visit& visit)
{
  using Core = core::PatchGrid;
  using Message = PressureGrid;
  visit({"nx", "-", "number of cells along x"}, &Core::nx, &Message::nx);
  visit({"ny", "-", "number of cells along y"}, &Core::ny, &Message::ny);
  visit({"dx", "m", "length of a cell along the track"}, &Core::dx, &Message::dx);
  visit({"dy", "m", "width of a cell across the track"}, &Core::dy, &Message::dy);
  visit({"x0", "m", "x of the centre of the first cell"}, &Core::x0, &Message::x0);
  visit({"y0", "m", "y of the centre of the first cell"}, &Core::y0, &Message::y0);
}

/// Fields of a highest stress.
template <typename Visit>
void visitPeak(const Visit& visit)
{
  using Core = core::StressPeak;
  using Message = StressPeak;
  visit({"value", "Pa", "the stress"}, &Core::value, &Message::value);
  visit({"x", "m", "along the track, forward, in the patch frame"}, &Core::x, &Message::x);
  visit({"y", "m", "across the track, left, along the arc of the rail's section"}, &Core::y, &Message::y);
  visit({"depth", "m", "below the surface, along its normal"}, &Core::depth, &Message::depth);
}

/// Numbers of the stress beneath a patch, without the peaks and the field.
template <typename Visit>
void visitStress(const Visit& visit)
{
  using Core = core::PatchStress;
  using Message = PatchStress;
  visit({"load_factor", "-", "max_pressure over the yield stress in shear; 0 if the yield stress is not given"},
        &Core::load_factor, &Message::load_factor);
  visit({"shakedown_limit", "-", "load_factor above which the body cannot shake down to an elastic state"},
        &Core::shakedown_limit, &Message::shakedown_limit);
}

/// Fields of the forces of a wheel.
template <typename Visit>
void visitWheel(const Visit& visit)
{
  using Core = core::WheelForces;
  using Message = WheelForces;
  visit({"vertical_force", "N", "Q, down positive"}, &Core::vertical, &Message::vertical_force);
  visit({"lateral_force", "N", "Y, outward positive"}, &Core::lateral, &Message::lateral_force);
}

/// Number of one of the displacements of a rail.
struct RailPart
{
  core::RailDeflection core::RailResult::*displacement;
  double core::RailDeflection::*part;

  template <typename Rail>
  auto& operator()(Rail& rail) const
  {
    return rail.*displacement.*part;
  }
};

/// Fields of a rail.
template <typename Visit>
void visitRail(const Visit& visit)
{
  using Core = core::RailResult;
  using Moved = core::RailDeflection;
  using Message = RailDeflection;
  visit({"lateral", "m", "displacement from the ideal track, outward positive"},
        RailPart{&Core::deflection, &Moved::lateral}, &Message::lateral);
  visit({"vertical", "m", "displacement from the ideal track, up positive"},
        RailPart{&Core::deflection, &Moved::vertical}, &Message::vertical);
  visit({"roll", "rad", "rotation, positive if the crown moves outward"}, RailPart{&Core::deflection, &Moved::roll},
        &Message::roll);
  visit({"lateral_force", "N", "lateral force that bends the rail, outward positive"}, &Core::lateral_force,
        &Message::lateral_force);
  visit({"vertical_force", "N", "vertical force of the wheel, down positive"}, &Core::vertical_force,
        &Message::vertical_force);
  visit({"moment", "N m", "moment of both about the reference point of the head, outward roll positive"}, &Core::moment,
        &Message::moment);
  visit({"given_lateral", "m", "part of lateral by the line and with the state"},
        RailPart{&Core::given, &Moved::lateral}, &Message::given_lateral);
  visit({"given_vertical", "m", "part of vertical by the line and with the state"},
        RailPart{&Core::given, &Moved::vertical}, &Message::given_vertical);
  visit({"given_roll", "rad", "part of roll by the line and with the state"}, RailPart{&Core::given, &Moved::roll},
        &Message::given_roll);
}
}  // namespace wheel_rail_contact
