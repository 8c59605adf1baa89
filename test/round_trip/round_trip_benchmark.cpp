// SPDX-License-Identifier: BSD-3-Clause
// Time from a state to its result in a lockstep loop with a running contact node: by the topics, and by a persistent
// connection to the service ~evaluate. Both take turns, with the same states.
//   round_trip_benchmark [STEPS [NODE]]     default: 5000 steps, /contact_node
#include <wheel_rail_contact/EvaluateWheelset.h>

#include "../ros/live/contact_client.h"
#include "../standard_headers.h"

namespace
{
using namespace wheel_rail_contact;

constexpr double rate = 1000;         ///< of the stamps [Hz]
constexpr int unmeasured = 200;       ///< first steps, in which buffers grow
constexpr double amplitude = 2e-3;    ///< of the lateral motion [m]
constexpr double frequency = 1.5;     ///< of the lateral motion [Hz]
constexpr double load_force = 2e5;    ///< [N], downward
constexpr double milliseconds = 1e3;  ///< in a second

EvaluateWheelset::Request stateAt(int step)
{
  const ros::Time stamp = ros::Time(1) + ros::Duration(step / rate);
  EvaluateWheelset::Request state;
  state.pose = ContactClient::pose(amplitude * std::sin(2 * M_PI * frequency * step / rate), stamp);
  state.load = ContactClient::load(-load_force, stamp);
  return state;
}

/// Wall time of an evaluation in the node [s].
/// @throw std::runtime_error if the result is not usable, or not that of the state.
double evaluationTime(const WheelsetContact& result, const EvaluateWheelset::Request& state)
{
  if (result.header.stamp != state.pose.header.stamp)
  {
    throw std::runtime_error("stamp of the result = " + std::to_string(result.header.stamp.toSec()) +
                             " s: must be that of the state, " + std::to_string(state.pose.header.stamp.toSec()) +
                             " s. Is there another publisher on the topics?");
  }
  if (result.status != WheelsetContact::OK && result.status != WheelsetContact::LIFT_OFF)
  {
    throw std::runtime_error("status of the result = " + std::to_string(result.status) +
                             ": must be usable; reason: " + result.status_text);
  }
  return result.solve_time;
}

/// Client of the topics and of the service of a node. Each request sends a state, waits for its result, and returns
/// evaluationTime().
class BothWays
{
 public:
  explicit BothWays(const std::string& node)
      : topics_("/", node), evaluate_(ros::NodeHandle().serviceClient<EvaluateWheelset>(node + "/evaluate", true))
  {
  }
  double byTopics(const EvaluateWheelset::Request& state)
  {
    const std::optional<WheelsetContact> result = topics_.request(state.pose, state.load);
    return result ? evaluationTime(*result, state) : throw std::runtime_error("no result from the topics of the node");
  }
  double byService(const EvaluateWheelset::Request& state)
  {
    EvaluateWheelset call;
    call.request = state;
    if (!evaluate_.call(call))
    {
      throw std::runtime_error("no result from the service " + evaluate_.getService());
    }
    return evaluationTime(call.response.contact, state);
  }

 private:
  ContactClient topics_;
  ros::ServiceClient evaluate_;
};

/// Times of all steps [s].
struct Times
{
  std::vector<double> round_trip;
  std::vector<double> evaluation;  ///< in the node
};

template <typename Request>
void measure(const Request& request, Times& times)
{
  const ros::WallTime start = ros::WallTime::now();
  times.evaluation.push_back(request());
  times.round_trip.push_back((ros::WallTime::now() - start).toSec());
}

double quantile(std::vector<double> times, double share)
{
  std::sort(times.begin(), times.end());
  return times[static_cast<std::size_t>(share * static_cast<double>(times.size() - 1))];
}

void print(const char* name, const Times& times)
{
  const auto figure = [](const std::vector<double>& values, double share)
  { return milliseconds * quantile(values, share); };
  std::printf("%-8s %zu round trips, median %.3f ms, 95 %% %.3f ms; evaluation median %.3f ms, 95 %% %.3f ms\n", name,
              times.round_trip.size(), figure(times.round_trip, 0.5), figure(times.round_trip, 0.95),
              figure(times.evaluation, 0.5), figure(times.evaluation, 0.95));
}

void run(int steps, const std::string& node)
{
  BothWays client(node);
  Times by_topic, by_service;
  for (int step = 0; step < unmeasured + steps; ++step)
  {
    if (step == unmeasured)
    {
      by_topic = by_service = Times();
    }
    const EvaluateWheelset::Request state = stateAt(step);
    measure([&] { return client.byTopics(state); }, by_topic);
    measure([&] { return client.byService(state); }, by_service);
  }
  print("topics", by_topic);
  print("service", by_service);
  std::printf("service / topics: median %.2f, 95 %% %.2f\n",
              quantile(by_service.round_trip, 0.5) / quantile(by_topic.round_trip, 0.5),
              quantile(by_service.round_trip, 0.95) / quantile(by_topic.round_trip, 0.95));
}
}  // namespace

int main(int argc, char** argv)
{
  ros::init(argc, argv, "round_trip_benchmark");
  try
  {
    const int steps = argc > 1 ? std::stoi(argv[1]) : 5000;
    if (steps < 1)
    {
      throw std::invalid_argument("STEPS = " + std::to_string(steps) + " must be at least 1");
    }
    run(steps, argc > 2 ? argv[2] : "/contact_node");
    return 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "round_trip_benchmark: %s\n", error.what());
    return 1;
  }
}
