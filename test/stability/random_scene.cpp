// SPDX-License-Identifier: BSD-3-Clause
#include "random_scene.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/profile/smoothing_spline.h"
#include "wheel_rail_contact/core/standard_profiles.h"

namespace wheel_rail_contact::core::stability
{
namespace
{
double uniform(Random& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Uniform in the logarithm.
double spread(Random& random, double low, double high)
{
  return std::exp(uniform(random, std::log(low), std::log(high)));
}

bool oneIn(Random& random, unsigned n)
{
  return random() % n == 0;
}

constexpr double point_distance = 2.5e-4;  ///< of sampled profiles [m]

/// Points along a profile, moved by white noise [m] and by `wear` (down at the height of y).
template <typename Wear>
std::vector<SampledPoint> sampled(const Profile& profile, double noise, const Wear& wear, Random& random)
{
  std::vector<SampledPoint> points;
  std::normal_distribution<double> deviation(0, noise);
  const auto count = static_cast<int>(profile.length() / point_distance);
  for (int i = 0; i <= count; ++i)
  {
    const CurvePoint p = profile.at(i * point_distance);
    const double off = deviation(random), length = std::hypot(p.dy, p.dz);
    points.push_back({p.y - off * p.dz / length, p.z + off * p.dy / length + wear(p.y)});
  }
  return points;
}

double bell(double y, double centre, double width)
{
  return std::exp(-0.5 * (y - centre) * (y - centre) / (width * width));
}

NamedProfile made(const char* name, const std::vector<ProfileSection>& sections)
{
  return {name, std::make_shared<Profile>(name, sections)};
}

/// Tread hollowed by 1.5 mm (a wheel's profile grows to the field side; worn metal is above its new surface).
double hollow(double y)
{
  return 1.5e-3 * bell(y, 0, 15e-3);
}

/// Gauge corner and crown worn by up to 1 mm.
double flattened(double y)
{
  return -1e-3 * bell(y, -25e-3, 10e-3);
}

double unworn(double /*y*/)
{
  return 0;
}

void drawTrack(ContactModelConfig& config, Random& random)
{
  constexpr std::array<double, 3> inclinations{0, 0.025, 0.05};
  config.track.rail_inclination =
      oneIn(random, 4) ? uniform(random, -0.02, 0.08) : inclinations[random() % inclinations.size()];
  config.track.gauge = oneIn(random, 2) ? 1.435 : uniform(random, 1.42, 1.47);
}

void drawMethod(ContactConfig& contact, Random& random, std::string& name)
{
  struct Choice
  {
    const char* name;
    NormalMethod method;
    double least_tolerance;  // the Seidel iteration costs the square of the number of cells
    int most_cells;          // each way, given by hand
  };
  constexpr Choice automatic{"auto", NormalMethod::automatic, 2e-3, 64};
  constexpr std::array<Choice, 9> others{{{"conjugate_gradient", NormalMethod::conjugate_gradient, 2e-3, 64},
                                          {"conjugate_gradient", NormalMethod::conjugate_gradient, 2e-3, 64},
                                          {"conjugate_gradient", NormalMethod::conjugate_gradient, 2e-3, 64},
                                          {"hertz", NormalMethod::hertz, 5e-3, 32},
                                          {"hertz", NormalMethod::hertz, 5e-3, 32},
                                          {"kik_piotrowski", NormalMethod::kik_piotrowski, 5e-3, 32},
                                          {"kik_piotrowski", NormalMethod::kik_piotrowski, 5e-3, 32},
                                          {"seidel", NormalMethod::seidel, 2e-2, 16},
                                          {"seidel_printed", NormalMethod::seidel_printed, 3e-2, 12}}};
  const Choice choice = oneIn(random, 3) ? others[random() % others.size()] : automatic;
  contact.method = choice.method;
  contact.tolerance = spread(random, choice.least_tolerance, 0.1);
  if (choice.method != NormalMethod::automatic && oneIn(random, 4))
  {
    const auto even = [&]() { return 4 + 2 * static_cast<int>(uniform(random, 0, 0.5 * choice.most_cells - 2)); };
    contact.cells_along = even();
    contact.cells_across = even();
  }
  char text[80];
  std::snprintf(text, sizeof text, ", tolerance %.3g, grid %d x %d", contact.tolerance, contact.cells_along,
                contact.cells_across);
  name = choice.name + std::string(text);
}

void drawRail(const std::vector<NamedTable>& tables, RailBendingConfig& bending, Random& random, std::string& name)
{
  using Model = RailBendingConfig::Model;
  using LateralForce = RailBendingConfig::LateralForce;
  name = "stiff";
  if (oneIn(random, 3))
  {
    return;
  }
  if (oneIn(random, 8))
  {
    bending.model = Model::prescribed;
    bending.prescribed = {uniform(random, -3e-3, 6e-3), uniform(random, -3e-3, 1e-3), uniform(random, -0.02, 0.03)};
    name = "prescribed";
    return;
  }
  const NamedTable& table = tables[random() % tables.size()];
  bending.model = Model::compliance;
  bending.table = table.table;
  name = table.name + ", force of the contact";
  if (oneIn(random, 6))
  {
    bending.lateral_force = LateralForce::constant;
    bending.lateral_force_value = uniform(random, -2e4, 6e4);
    name = table.name + ", constant force";
  }
  else if (oneIn(random, 6))
  {
    bending.lateral_force = LateralForce::topic;
    name = table.name + ", force given";
  }
}
}  // namespace

Pool makePool(std::vector<NamedTable> tables)
{
  constexpr unsigned long noise_seed = 7;
  constexpr double noise = 5e-6, points_off = 5e-7;
  Random random(noise_seed);
  const Profile wheel = s1002Wheel(), rail = rail60E1(), manchester = railUic60Manchester();
  Pool pool;
  pool.tables = std::move(tables);
  pool.wheels = {{"S1002", std::make_shared<Profile>(wheel)},
                 made("S1002 through points", interpolatingSpline(sampled(wheel, points_off, unworn, random))),
                 made("S1002 measured", smoothingSpline(sampled(wheel, noise, unworn, random), noise)),
                 made("S1002 hollow", smoothingSpline(sampled(wheel, noise, hollow, random), noise))};
  pool.rails = {{"60E1", std::make_shared<Profile>(rail)},
                {"UIC60_manchester", std::make_shared<Profile>(manchester)},
                made("60E1 through points", interpolatingSpline(sampled(rail, points_off, unworn, random))),
                made("60E1 measured", smoothingSpline(sampled(rail, noise, unworn, random), noise)),
                made("60E1 worn", smoothingSpline(sampled(rail, noise, flattened, random), noise))};
  return pool;
}

Scene randomScene(const Pool& pool, Random& random)
{
  Scene scene;
  const NamedProfile& wheel = pool.wheels[oneIn(random, 2) ? 0 : random() % pool.wheels.size()];
  const NamedProfile& rail = pool.rails[oneIn(random, 2) ? 0 : random() % pool.rails.size()];
  scene.profiles = wheel.name + " on " + rail.name;
  scene.config.wheel_profile = wheel.profile;
  scene.config.rail_profile = rail.profile;
  drawTrack(scene.config, random);
  scene.config.wheelset.solve_height_and_roll = !oneIn(random, 6);
  drawMethod(scene.config.contact, random, scene.method);
  drawRail(pool.tables, scene.config.rail_bending, random, scene.rail);
  return scene;
}

void Walk::load()
{
  const double wheel = oneIn(random_, 3) ? spread(random_, 1, 1e6) : spread(random_, 2e4, 1.5e5);
  const double transfer = oneIn(random_, 10) ? uniform(random_, -1.5, 1.5) : uniform(random_, -0.5, 0.5);
  state_.force_z = -2 * wheel;
  state_.torque_x = 2 * transfer * wheel * config_.wheelset.halfBase();
  for (double& force : state_.rail_lateral_force)
  {
    force = uniform(random_, -0.3, 0.6) * wheel;
  }
}

void Walk::jump()
{
  state_.y = oneIn(random_, 20) ? uniform(random_, -0.04, 0.04) : uniform(random_, -0.010, 0.010);
  state_.yaw = oneIn(random_, 2) ? 0 : uniform(random_, -1, 1) * (oneIn(random_, 4) ? 0.06 : 0.01);
  state_.roll = uniform(random_, -5e-4, 5e-4);
  state_.z = config_.wheelset.rolling_radius + uniform(random_, -4e-4, 2e-4);
  load();
}

void Walk::step()
{
  std::normal_distribution<double> unit;
  state_.y += 3e-4 * unit(random_);
  state_.yaw += state_.yaw != 0 ? 3e-4 * unit(random_) : 0;
  state_.roll += 2e-5 * unit(random_);
  state_.z += 1e-5 * unit(random_);
  const double ratio = std::exp(0.05 * unit(random_));
  state_.force_z *= ratio;
  state_.torque_x *= ratio;
}

const WheelsetState& Walk::next()
{
  const bool was_close = close_;
  close_ = !first_ && !was_close && oneIn(random_, 2);
  if (close_)
  {
    state_.y += close;
  }
  else if (!first_)
  {
    oneIn(random_, 3) ? jump() : step();
  }
  first_ = false;
  return state_;
}

double beyondPlay(const ContactModelConfig& config, const WheelsetState& state)
{
  constexpr double flange_thickness = 0.0325;
  const double over_flanges = config.wheelset.flange_back_distance + 2 * flange_thickness;
  return std::abs(state.y) - 0.5 * (config.track.gauge - over_flanges);
}

std::string describe(const WheelsetState& state)
{
  char text[300];
  std::snprintf(text, sizeof text,
                "y %.9g m, z %.9g m, yaw %.9g rad, roll %.9g rad, force_z %.9g N, torque_x %.9g N m, "
                "rail forces %.9g N and %.9g N",
                state.y, state.z, state.yaw, state.roll, state.force_z, state.torque_x, state.rail_lateral_force[0],
                state.rail_lateral_force[1]);
  return text;
}

std::string describe(const Scene& scene)
{
  char text[120];
  std::snprintf(text, sizeof text, "; inclination %.4g rad, gauge %.4f m, height and roll %s",
                scene.config.track.rail_inclination, scene.config.track.gauge,
                scene.config.wheelset.solve_height_and_roll ? "from the load" : "given");
  return scene.profiles + "; " + scene.method + "; rail " + scene.rail + text;
}
}  // namespace wheel_rail_contact::core::stability
