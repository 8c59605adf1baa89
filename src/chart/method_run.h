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
/// Lateral distance of consecutive messages [m].
constexpr double step = 0.05e-3;

/// Largest number of steps from the scene to a message: 0.2 mm. Over this distance a narrow pressure lobe takes all
/// positions relative to the cells of a coarse grid.
constexpr int longest_reach = 4;

/// Values of contact/tolerance for `auto` [-].
constexpr std::array<double, 4> tolerances{0.1, 0.03, 0.01, 0.003};

/// Setting to be compared: a method on one grid, or `auto` at one tolerance.
struct Choice
{
  NormalMethod method = NormalMethod::automatic;
  GridSize grid;         ///< of a fixed method
  double tolerance = 0;  ///< contact/tolerance [-]; 0: the default, for fixed methods only

  bool isAutomatic() const { return method == NormalMethod::automatic; }
  bool isSeidel() const { return method == NormalMethod::seidel || method == NormalMethod::seidel_printed; }
};

/// Every method on every grid of `auto`, from coarse to fine, then `auto` at each of the tolerances.
std::vector<Choice> allChoices();

ContactConfig contactConfig(const Choice& choice);

/// A method running on a scene.
class MethodRun
{
 public:
  virtual ~MethodRun() = default;

  /// Solves the scene at the position `offset` steps across the track, starting from the last result if there is one.
  /// @param offset  a multiple of 1 / Scene::statesPerStep()
  virtual void solve(double offset) = 0;
  /// The next result starts cold.
  virtual void reset() = 0;
  /// Outcome of the last result.
  virtual Outcome outcome() const = 0;
};

/// A contact on which the methods are compared.
class Scene
{
 public:
  Scene(std::string name, std::string title) : name_(std::move(name)), title_(std::move(title)) {}
  virtual ~Scene() = default;

  const std::string& name() const { return name_; }
  const std::string& title() const { return title_; }
  /// "wheelset": whole calculation; "normal": normal problem only.
  virtual const char* kind() const = 0;
  /// Number of states per step in the sweep for the longest time.
  virtual int statesPerStep() const = 0;

  /// Reference solution at the position `offset` steps across the track: conjugate gradients on a fine grid.
  virtual Outcome truth(const GridSize& grid, int offset) = 0;
  /// Method run for a choice; it starts cold. Runs of equal choices share their solver: use only the latest one.
  virtual std::unique_ptr<MethodRun> makeRun(const Choice& choice) = 0;

 private:
  std::string name_, title_;
};
}  // namespace wheel_rail_contact::core::chart
