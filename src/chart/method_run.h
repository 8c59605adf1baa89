// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "chart/outcome.h"
#include "wheel_rail_contact/core/config.h"

namespace wheel_rail_contact::core::chart
{
/// Way across the track from one message to the next [m].
constexpr double step = 0.05e-3;

/// Most steps from the scene to a message: 0.2 mm, over which a narrow lobe of the pressure meets a coarse grid's cells
/// in all ways.
constexpr int longest_reach = 4;

/// contact/tolerance that `auto` is asked for [-].
constexpr std::array<double, 4> tolerances{0.1, 0.03, 0.01, 0.003};

/// What is asked of a contender: a method on one grid, or `auto`.
struct Choice
{
  NormalMethod method = NormalMethod::automatic;
  GridSize grid;         ///< of a fixed method
  double tolerance = 0;  ///< contact/tolerance [-]; 0: the default, for fixed methods only

  bool isAutomatic() const { return method == NormalMethod::automatic; }
  bool isSeidel() const { return method == NormalMethod::seidel || method == NormalMethod::seidel_printed; }
};

/// Every method on every grid of the ladder, coarse to fine, then auto at each of the tolerances.
std::vector<Choice> allChoices();

ContactConfig contactConfig(const Choice& choice);

/// A method at work on a scene.
class MethodRun
{
 public:
  virtual ~MethodRun() = default;

  /// Answers the scene at the place `offset` steps across; starts from the last answer, if there is one.
  virtual void result(int offset) = 0;
  /// The next answer starts cold.
  virtual void forget() = 0;
  /// Of the last answer.
  virtual Outcome outcome() const = 0;
};

/// What the methods are compared on.
class Scene
{
 public:
  Scene(std::string name, std::string title) : name_(std::move(name)), title_(std::move(title)) {}
  virtual ~Scene() = default;

  const std::string& name() const { return name_; }
  const std::string& title() const { return title_; }
  /// wheelset: the whole chain; normal: the normal problem alone.
  virtual const char* kind() const = 0;

  /// The answer at the place `offset` steps across, by conjugate gradients on a fine grid.
  virtual Outcome truth(const GridSize& grid, int offset) = 0;
  /// The contender starts cold. Of equal choices only the last one may be used.
  virtual std::unique_ptr<MethodRun> contender(const Choice& choice) = 0;

 private:
  std::string name_, title_;
};
}  // namespace wheel_rail_contact::core::chart
