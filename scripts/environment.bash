# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Sourced by setup, test, demo and pictures: the same surroundings however and wherever they are called.

exec < /dev/null
umask 022
root=$(cd -P "$(dirname "${BASH_SOURCE[0]}")/.." > /dev/null && pwd)
build=$root/build

# ROS belongs to the system's python3: one of pyenv, conda or a virtual environment lacks its modules.
export PATH=/usr/bin:/bin:/usr/sbin:/sbin:$PATH
unset PYTHONHOME CDPATH GREP_OPTIONS MAKEFLAGS DESTDIR
export LC_ALL=C.UTF-8

# A shell that has sourced this build's own setup file gets the same build as one that has not.
if [[ -n ${CMAKE_PREFIX_PATH:-} ]]; then
  CMAKE_PREFIX_PATH=$(tr ':' '\n' <<< "$CMAKE_PREFIX_PATH" | grep --invert-match --line-regexp --fixed-strings \
    "$build/devel" | paste --serial --delimiters=: || true)
  export CMAKE_PREFIX_PATH
fi

# Everything runs on this machine, whatever its name resolves to, and leaves its logs in the build folder.
unset ROS_IP
export ROS_HOSTNAME=localhost
export ROS_HOME=$build/ros_home

say()
{
  printf '\n== %s\n' "$*" >&2
}

die()
{
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}

# Sources a ROS or catkin setup file, which are not written for `set -u`.
source_setup()
{
  set +u
  # shellcheck disable=SC1090
  source "$1"
  set -u
}

# As many compilers as there are cores, but not more than memory has room for (1.5 GB each).
jobs_that_fit()
{
  local cores memory
  cores=$(nproc)
  memory=$(awk '/^MemAvailable:/ { print int($2 / 1500000) }' /proc/meminfo)
  memory=$((memory > 1 ? memory : 1))
  echo $((cores < memory ? cores : memory))
}
