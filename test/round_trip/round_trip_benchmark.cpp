// SPDX-License-Identifier: BSD-3-Clause
// Time from a state to its result in a lockstep loop with a running contact node: by the topics, and by a persistent
// connection to the service ~evaluate. Both take turns, with the same states.
//   round_trip_benchmark [STEPS [NODE]]     default: 5000 steps, /contact_node
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include "../standard_headers.h"

#include <wheel_rail_contact/EvaluateWheelset.h>
#include <wheel_rail_contact/WheelsetContact.h>

namespace
{
using namespace wheel_rail_contact;

constexpr double timeout = 10;        ///< for a connection or a result [s]
constexpr double rate = 1000;         ///< of the stamps [Hz]
constexpr int unmeasured = 200;       ///< first steps, in which buffers grow
constexpr double amplitude = 2e-3;    ///< of the lateral motion [m]
constexpr double frequency = 1.5;     ///< of the lateral motion [Hz]
constexpr double load_force = 2e5;    ///< [N], downward
constexpr double milliseconds = 1e3;  ///< in a second

EvaluateWheelset::Request stateAt(int step)
{
  EvaluateWheelset::Request state;
  state.pose.header.stamp = ros::Time(1) + ros::Duration(step / rate);
  state.pose.header.frame_id = "track";
  state.pose.pose.position.y = amplitude * std::sin(2 * M_PI * frequency * step / rate);
  state.pose.pose.orientation.w = 1;
  state.load.header.stamp = state.pose.header.stamp;
  state.load.wrench.force.z = -load_force;
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

/// Client of the topics of a node.
class TopicClient
{
 public:
  explicit TopicClient(const std::string& node)
      : pose_(nh_.advertise<geometry_msgs::PoseStamped>("wheelset/pose", 10)),
        load_(nh_.advertise<geometry_msgs::WrenchStamped>("wheelset/load", 10)),
        contact_(nh_.subscribe<WheelsetContact>(
            node + "/contact", 10, [this](const WheelsetContact::ConstPtr& result) { result_ = result; },
            ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()))
  {
    waitUntil([this] { return pose_.getNumSubscribers() && load_.getNumSubscribers() && contact_.getNumPublishers(); });
    ros::WallDuration(0.5).sleep();  // the node completes the connection a moment later
  }

  /// Sends a state and waits for its result. @return evaluationTime()
  double request(const EvaluateWheelset::Request& state)
  {
    result_.reset();
    pose_.publish(state.pose);
    load_.publish(state.load);
    waitUntil([this] { return result_ != nullptr; });
    return evaluationTime(*result_, state);
  }

 private:
  template <typename Condition>
  static void waitUntil(const Condition& done)
  {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(timeout);
    while (!done())
    {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1));
      if (!ros::ok() || ros::WallTime::now() > end)
      {
        throw std::runtime_error("no connection to the topics of the node, or no result");
      }
    }
  }

  ros::NodeHandle nh_;
  ros::Publisher pose_, load_;
  ros::Subscriber contact_;
  WheelsetContact::ConstPtr result_;
};

/// Client of the service of a node.
class ServiceClient
{
 public:
  explicit ServiceClient(const std::string& node)
      : evaluate_(ros::NodeHandle().serviceClient<EvaluateWheelset>(node + "/evaluate", true))
  {
  }

  /// Sends a state and waits for its result. @return evaluationTime()
  double request(const EvaluateWheelset::Request& state)
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
  ros::ServiceClient evaluate_;
};

/// Times of all steps [s].
struct Times
{
  std::vector<double> round_trip;
  std::vector<double> evaluation;  ///< in the node
};

template <typename Client>
void measure(Client& client, const EvaluateWheelset::Request& state, Times& times)
{
  const ros::WallTime start = ros::WallTime::now();
  times.evaluation.push_back(client.request(state));
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
  TopicClient topics(node);
  ServiceClient service(node);
  Times by_topic, by_service;
  for (int step = 0; step < unmeasured + steps; ++step)
  {
    if (step == unmeasured)
    {
      by_topic = by_service = Times();
    }
    const EvaluateWheelset::Request state = stateAt(step);
    measure(topics, state, by_topic);
    measure(service, state, by_service);
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
