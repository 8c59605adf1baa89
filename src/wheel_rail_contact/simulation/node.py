# SPDX-License-Identifier: BSD-3-Clause
"""The contact calculation of a running node: over its topics, or over its service. The program calls rospy.init_node()."""
import math
import threading
from types import SimpleNamespace

import rospy
from geometry_msgs.msg import PoseStamped, TwistStamped, WrenchStamped

from wheel_rail_contact.msg import WheelsetContact
from wheel_rail_contact.srv import EvaluateWheelset, EvaluateWheelsetRequest

from ..command import Failure
from ..core.derivatives import named_derivatives
from ..message_constants import SIDES, STATUSES, USABLE
from .contact import SOLVED, require_suitable
from .wheelset import Request

FIRST_STAMP = 1000 * 10**9  # [ns]; messages with a stamp of 0 are dropped, and trial states are before the start
MINUTE = 60                 # longest wait for the service, or for the first result [s]
RESULT_WAIT = 10            # longest one, for a result [s]; builds with sanitizers are slow
ATTEMPT = 0.1               # between trial states [s]
TRIAL_FORCE = -100e3        # a light wheelset [N]; the result of the trial is not used
QUEUE_SIZE = 1              # in lockstep no second message waits


class _NodeContact:
    """A contact node, and its service for the state at rest."""

    def __init__(self, node, frame):
        """frame: parameter track/frame of the node. Raises Failure if it expects another load."""
        self._node, self._frame, self.height_given = node, frame, require_load(node)

    def static_start(self, request):
        """Result of a wheelset at rest under the load of the request."""
        return _answer(_service(self._node, "static_start"), request, self._frame)


class ServiceContact(_NodeContact):
    """A contact node, over its service `evaluate` with one persistent connection."""

    def __init__(self, node, frame):
        """Waits for the service; arguments and failures as for a node."""
        self._call = _service(node, "evaluate")
        super().__init__(node, frame)

    def evaluate(self, request):
        return _answer(self._call, request, self._frame)


def _service(node, name):
    """Persistent connection to a service of a node."""
    name = rospy.resolve_name(f"{node}/{name}")
    try:
        rospy.wait_for_service(name, MINUTE)
    except rospy.ROSException as error:
        raise Failure(f"no service {name} within a minute") from error
    return rospy.ServiceProxy(name, EvaluateWheelset, persistent=True)


def _answer(service, request, frame):
    try:
        return reply_of(service(message_of(request, frame)).contact)
    except rospy.ServiceException as error:
        raise Failure(f"the call of {service.resolved_name} failed: {error}") from error


class TopicContact(_NodeContact):
    """A contact node, over its topics, in lockstep: publishes pose, twist and load, and waits for the result with their stamp."""

    def __init__(self, node, frame):
        """Waits until the node replies; arguments and failures as for a node."""
        super().__init__(node, frame)
        self._latest, self._arrived = None, threading.Condition()
        self._publishers = [rospy.Publisher(f"wheelset/{name}", kind, queue_size=QUEUE_SIZE, tcp_nodelay=True)
                            for name, kind in (("pose", PoseStamped), ("twist", TwistStamped), ("load", WrenchStamped))]
        # Without tcp_nodelay, each result may wait for up to 40 ms in the socket.
        self._topic = rospy.Subscriber(f"{node}/contact", WheelsetContact, self._receive, queue_size=QUEUE_SIZE,
                                       tcp_nodelay=True).resolved_name
        # Messages are lost until all connections exist: trial states are sent until the first result.
        times = range(-MINUTE * 10**9, 0, round(ATTEMPT * 1e9))
        if not any(self._has_result(Request(time=time, force_z=TRIAL_FORCE), ATTEMPT) for time in times):
            raise Failure(f"no result on {self._topic} within a minute")

    def evaluate(self, request):
        try:
            if self._has_result(request, RESULT_WAIT):
                return reply_of(self._latest)
        except rospy.ROSException as error:  # rosnode kill
            raise Failure(error) from error
        raise Failure(f"no result on {self._topic} within {RESULT_WAIT} s")

    def _has_result(self, request, seconds):
        """Sends a state; whether its result, in `_latest`, is here within this time [s]."""
        message = message_of(request, self._frame)
        with self._arrived:
            self._latest = None  # that of an earlier request of this step has the same stamp
            for publisher, part in zip(self._publishers, (message.pose, message.twist, message.load)):
                publisher.publish(part)
            stamp = message.pose.header.stamp
            return self._arrived.wait_for(lambda: self._latest and self._latest.header.stamp == stamp, seconds)

    def _receive(self, message):
        with self._arrived:
            self._latest = message
            self._arrived.notify()


def require_load(node):
    """Raises Failure if the parameters of a node expect another load. Returns whether they expect height and roll."""
    name = rospy.resolve_name(node)
    if not rospy.has_param(name):
        raise Failure(f"there are no parameters of a node {name}: it does not run")

    def value_of(parameter, default):
        value = rospy.get_param(f"{name}/{parameter}", default)
        return f"[{', '.join(map(str, value))}]" if isinstance(value, list) else str(value).lower()

    require_suitable(value_of, prefix=f"{name}/")
    return value_of("wheelset/free", SOLVED) != SOLVED


def message_of(request, frame):
    """Pose, velocity and load of the axle with one stamp. The rotation is zero: it is a result."""
    message = EvaluateWheelsetRequest()
    for part in (message.pose, message.twist, message.load):
        part.header.stamp, part.header.frame_id = rospy.Time(0, FIRST_STAMP + request.time), frame
    pose, twist, load = message.pose.pose, message.twist.twist, message.load.wrench
    pose.position.x, pose.position.y, pose.position.z = request.x, request.y, request.z
    sine, cosine, q = math.sin(request.yaw / 2), math.cos(request.yaw / 2), pose.orientation
    q.x, q.y = cosine * math.sin(request.roll / 2), sine * math.sin(request.roll / 2)  # the roll is before the yaw
    q.z, q.w = sine * math.cos(request.roll / 2), cosine * math.cos(request.roll / 2)
    twist.linear.x, twist.linear.y, twist.linear.z = request.speed, request.lateral_velocity, request.vertical_velocity
    twist.angular.x, twist.angular.z = request.roll_rate, request.yaw_rate
    load.force.z, load.torque.x = request.force_z, request.torque_x
    return message


def reply_of(message):
    """Result of a node, with the names of the Python module; only what the example uses."""
    patches = [SimpleNamespace(side=SIDES[patch.side], pose=_with_roll(patch.pose), normal_force=patch.normal_force,
                               rolling_radius=patch.rolling_radius, creep=patch.creep) for patch in message.patches]
    return SimpleNamespace(
        usable=message.status in USABLE, status=STATUSES[message.status], status_text=message.status_text,
        wheelset=_with_roll(message.wheelset), rotation=message.rotation, rail_wrench=message.rail_wrench,
        left_rail=message.left_rail, right_rail=message.right_rail, patches=patches,
        derivatives=named_derivatives(message.derivatives))


def _with_roll(pose):
    """Position, and rotation about x [rad] of a pose that is rotated about x and z only."""
    q = pose.orientation
    roll = math.atan2(2 * (q.w * q.x + q.y * q.z), 1 - 2 * (q.x * q.x + q.y * q.y))
    return SimpleNamespace(position=pose.position, roll=roll)
