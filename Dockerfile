# SPDX-License-Identifier: BSD-3-Clause
# Image of the live node on ROS Noetic (Ubuntu 20.04):
#
#   docker build --pull --tag wheel_rail_contact .
#   docker run --rm --network host wheel_rail_contact
#
# Not verified: this file was never built, because no container registry was reachable where it was written. The check
# check_setup runs scripts/setup with the environment and without the package lists of this base image.
#
# --pull: images from before June 2025 contain an expired key. The newer ones install ROS packages from the final snapshot of
# Noetic (github.com/docker-library/official-images, pull request 19221). ros:noetic-ros-core contains no rosdep.
FROM ros:noetic-ros-base-focal

# Without rviz. To include it, remove this line.
ENV WHEEL_RAIL_CONTACT_RVIZ=OFF

COPY . /opt/wheel_rail_contact
RUN /opt/wheel_rail_contact/scripts/setup && rm -rf /var/lib/apt/lists/*

# The setup file of the build folder includes that of ROS.
ENTRYPOINT ["/opt/wheel_rail_contact/build/devel/env.sh"]
CMD ["roslaunch", "wheel_rail_contact", "contact.launch"]
