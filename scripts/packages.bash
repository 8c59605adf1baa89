# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Sourced by setup, after environment.bash and rosdep.bash, and by make_deb. Installs packages with apt: on ROS Noetic those that
# package.xml requires, otherwise those of Debian or Ubuntu.

: "${root:?}" "${build:?}"

# Packages of Debian and Ubuntu by purpose. package.xml lists the same dependencies for rosdep.
distribution_packages=(
  # build
  g++ make cmake catkin python3-setuptools libeigen3-dev libyaml-cpp-dev libbz2-dev libroslz4-dev
  libboost-program-options-dev
  ros-message-generation ros-message-runtime
  libroscpp-dev libroslib-dev libstd-msgs-dev libgeometry-msgs-dev libvisualization-msgs-dev libdiagnostic-msgs-dev
  libtf2-dev libtf2-msgs-dev libtf2-ros-dev libdiagnostic-updater-dev libnodelet-dev libnodeletlib-dev pluginlib-dev
  librviz-dev libopengl-dev qtbase5-dev  # Debian 11: librviz-dev does not depend on libopengl-dev, but requires it
  pybind11-dev python3-dev  # Python module of the core
  ros-std-msgs ros-geometry-msgs ros-visualization-msgs ros-diagnostic-msgs
  # run
  rosbash rosout rospack-tools libnodeletlib-tools
  python3-rospy python3-roslaunch python3-rosbag python3-rostopic python3-rosnode python3-rosmsg
  python3-std-msgs python3-geometry-msgs python3-visualization-msgs python3-diagnostic-msgs
  python3-tf2-msgs tf2-tools
  # test
  libgtest-dev libbenchmark-dev librostest-dev python3-rostest
  # demo: rviz and a virtual screen
  rviz xvfb imagemagick libgl1-mesa-dri
  # contact_campaign: setpriv, and a module that the Dask package of Debian 11 requires without depending on it
  util-linux python3-tornado
  # tables, pictures and reports
  python3-numpy python3-yaml python3-matplotlib python3-pil
)

# Packages for checks. Some distributions lack some of them; their checks are skipped.
check_packages=(
  clang-format clang-tidy doxygen python3-rosdep2 shellcheck pyflakes3 catkin-lint catkin-tools chromium-headless-shell
)

# Packages for rail_compliance (finite elements) and contact_campaign (Dask). They have no public rosdep rule.
command_packages=(calculix-ccx gmsh python3-distributed)

# The packages that are left out if no package source contains them.
optional_packages=()

sorted()
{
  printf '%s\n' "$@" | sort --unique
}

# Prints those of the packages that are not installed.
missing_packages()
{
  # shellcheck disable=SC2016
  local format='${db:Status-Status} ${Package}\n'
  comm -13 <(dpkg-query --show --showformat "$format" | sed --quiet 's/^installed //p' | sort --unique) <(sorted "$@")
}

# Prints those of the packages that apt can install.
available_packages()
{
  apt-cache policy "$@" | awk '/^[^ ]+:$/ { name = substr($1, 1, length($1) - 1) }
    /^  Candidate: / && $2 != "(none)" { print name }' | sort --unique
}

# Prints those of the packages that apt cannot install.
absent_packages()
{
  comm -13 <(available_packages "$@") <(sorted "$@")
}

required_absent_packages()
{
  comm -23 <(absent_packages "$@") <(sorted "${optional_packages[@]}")
}

package_lists_exist()
{
  # shellcheck disable=SC2016
  [[ -n $(apt-get indextargets --format '$(FILENAME)' 'Created-By: Packages') ]]
}

root_available()
{
  [[ $(id -u) -eq 0 ]] || command -v sudo > /dev/null
}

# require_root COMMAND...: ends the script if it cannot run this command as root.
require_root()
{
  root_available || die "sudo is not installed; run this command as root, then this script again: $*"
}

as_root()
{
  if [[ $(id -u) -eq 0 ]]; then
    "$@"
  else
    sudo "$@"
  fi
}

# --no-remove: packages of other sources, for example of ROS 2, may conflict with those of the distribution.
apt_install()
{
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends --no-remove \
    --option DPkg::Lock::Timeout=600 --option Dpkg::Use-Pty=0 --quiet "$@"
}

update_package_lists()
{
  log "[1/3] updating the package lists"
  as_root apt-get update --option DPkg::Lock::Timeout=600 --quiet || log "some package lists could not be updated"
}

# install_packages ADVICE PACKAGE...: installs the packages. ADVICE is part of the error message if one is not available.
install_packages()
{
  local advice=$1 absent available
  shift
  [[ $# -gt 0 ]] || return 0
  if ! package_lists_exist; then
    require_root apt-get update
    update_package_lists
  elif root_available && [[ -n $(required_absent_packages "$@") ]]; then
    update_package_lists  # they may be out of date
  fi
  mapfile -t absent < <(required_absent_packages "$@")
  [[ ${#absent[@]} -eq 0 ]] || die "not in the package sources of this system: ${absent[*]}. $advice"
  mapfile -t absent < <(absent_packages "$@")
  [[ ${#absent[@]} -eq 0 ]] || log "[1/3] left out, not in the package sources of this system: ${absent[*]}"
  mapfile -t available < <(available_packages "$@")
  [[ ${#available[@]} -gt 0 ]] || return 0
  require_root apt-get install --no-install-recommends "${available[@]}"
  log "[1/3] installing ${#available[@]} packages: ${available[*]}"
  apt_install "${available[@]}" || { update_package_lists && apt_install "${available[@]}"; } ||
    die "apt-get could not install these packages: ${available[*]}"
}

# install_distribution_packages SYSTEM ADVICE: SYSTEM is ID and version of the distribution.
install_distribution_packages()
{
  local missing
  # python3-rosdep, from the package sources of ROS, contains the same command and conflicts with python3-rosdep2.
  [[ -n $(missing_packages python3-rosdep) ]] || check_packages=("${check_packages[@]/python3-rosdep2/python3-rosdep}")
  # The rviz of Debian 13 uses Qt 6, and does not depend on the plugins that read its icons.
  [[ $1 != "debian 13" ]] || distribution_packages=("${distribution_packages[@]/qtbase5-dev/qt6-base-dev}" qt6-svg-plugins)
  mapfile -t missing < <(missing_packages "${distribution_packages[@]}" "${check_packages[@]}" "${command_packages[@]}")
  # Debian 12 has all of them, and all checks run there.
  [[ $1 == "debian 12" ]] || optional_packages=("${check_packages[@]}" "${command_packages[@]}")
  install_packages "$2" "${missing[@]}"
}

# Prints everything that the required packages depend on.
rosdep_state()
{
  cat "$root/package.xml"
  echo "${WHEEL_RAIL_CONTACT_RVIZ:-}"
  dpkg-query --show
}

install_noetic_packages()
{
  local stamp=$build/.rosdep from_rosdep missing
  [[ ! -f $stamp ]] || ! rosdep_state | cmp --silent - "$stamp" || return 0
  find_rosdep_rules
  log "[1/3] checking the dependencies of package.xml with rosdep"
  from_rosdep=$(rosdep_packages "${command_packages[@]}")
  mapfile -t from_rosdep <<< "$from_rosdep"
  mapfile -t missing < <(missing_packages g++ make "${command_packages[@]}" "${from_rosdep[@]}" | sed '/^$/d')
  optional_packages=("${command_packages[@]}")
  install_packages "Make sure that a package source of ROS Noetic is configured, and that apt-get update reports no error." \
    "${missing[@]}"
  mkdir -p "$build"
  rosdep_state > "$stamp"
}
