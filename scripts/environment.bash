# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Sourced by setup, test, demo, pictures and make_deb. Their environment then does not depend on the calling shell.

exec < /dev/null
umask 022
root=$(cd -P "$(dirname "${BASH_SOURCE[0]}")/.." > /dev/null && pwd)
build=$root/build

# ROS requires the python3 of the system. A python3 from pyenv, conda or a virtual environment lacks the ROS modules.
export PATH=/usr/bin:/bin:/usr/sbin:/sbin:$PATH
unset PYTHONHOME CDPATH GREP_OPTIONS MAKEFLAGS DESTDIR
unset LANGUAGE  # programs with translated messages follow it even in the locale C.UTF-8
export LC_ALL=C.UTF-8

# Removes the devel space of this build from CMAKE_PREFIX_PATH: the calling shell may have sourced its setup file.
if [[ -n ${CMAKE_PREFIX_PATH:-} ]]; then
  CMAKE_PREFIX_PATH=$(tr ':' '\n' <<< "$CMAKE_PREFIX_PATH" | grep --invert-match --line-regexp --fixed-strings \
    "$build/devel" | paste --serial --delimiters=: || true)
  export CMAKE_PREFIX_PATH
fi

# All nodes use localhost, because the host name may not resolve. ROS writes its logs to the build folder.
unset ROS_IP
export ROS_HOSTNAME=localhost
# rosdep keeps its rules in the ROS_HOME of the calling shell. The variable is exported, because these scripts call each other.
export CALLER_ROS_HOME=${CALLER_ROS_HOME-${ROS_HOME:-}}
export ROS_HOME=$build/ros_home

# Prints a progress message to standard error.
log()
{
  printf '\n== %s\n' "$*" >&2
}

die()
{
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}

# Sources a setup file of ROS or catkin. These files do not support `set -u`.
source_setup()
{
  set +u
  # shellcheck disable=SC1090
  source "$1"
  set -u
}

# Prints the number of parallel compilers: one per core, limited by the available memory (1.5 GB each).
parallel_jobs()
{
  local cores memory
  cores=$(nproc)
  memory=$(awk '/^MemAvailable:/ { print int($2 / 1500000) }' /proc/meminfo)
  memory=$((memory > 1 ? memory : 1))
  echo $((cores < memory ? cores : memory))
}
