// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <random>
#include <string>
#include <vector>

#include "wheel_rail_contact/core/wheelset_contact.h"

/// Random wheelsets on random tracks, and walks of states on them.
namespace wheel_rail_contact::core::stability
{
using Random = std::mt19937_64;

struct NamedTable
{
  std::string name;
  ComplianceTable table;
};

struct NamedProfile
{
  std::string name;
  std::shared_ptr<const Profile> profile;
};

/// What scenes are drawn from. The profiles: standard ones, the same as measured with noise and passed through every
/// point, and worn ones (hollow tread, flattened gauge corner) smoothed.
struct Pool
{
  std::vector<NamedProfile> wheels, rails;
  std::vector<NamedTable> tables;
};
Pool makePool(std::vector<NamedTable> tables);

/// A configuration, and what it was drawn from in words.
struct Scene
{
  ContactModelConfig config;
  std::string profiles, method, rail;
};
Scene randomScene(const Pool& pool, Random& random);

/// Walks through states: small steps, jumps to anywhere, and steps of 1 um along y alone.
class Walk
{
 public:
  /// Lateral step of a close neighbour [m].
  static constexpr double close = 1e-6;

  Walk(const ContactModelConfig& config, Random& random) : config_(config), random_(random) { jump(); }

  /// The next state; `isClose` tells if only y differs from the last, by `close`.
  const WheelsetState& next();
  bool isClose() const { return close_; }

 private:
  void jump();
  void step();
  void load();

  const ContactModelConfig& config_;
  Random& random_;
  WheelsetState state_;
  bool first_ = true;
  bool close_ = false;
};

/// Lateral position beyond that at which a flange of standard thickness (32.5 mm) would meet a vertical gauge face [m].
double beyondPlay(const ContactModelConfig& config, const WheelsetState& state);

std::string describe(const WheelsetState& state);
std::string describe(const Scene& scene);
}  // namespace wheel_rail_contact::core::stability
