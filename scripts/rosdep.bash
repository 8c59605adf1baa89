# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Sourced by setup, after environment.bash. Finds the packages that package.xml requires on ROS Noetic, with rosdep.

: "${root:?}"

# Noetic is end-of-life. rosdep 0.18 of Ubuntu 20.04 then skips it, despite --rosdistro.
rosdep_update=(update --rosdistro noetic --include-eol-distros)

run_rosdep()
{
  ROS_HOME=$rosdep_home rosdep "$@"
}

# Sets rosdep_home, the ROS_HOME with the rules of rosdep. Those of the calling shell are used if they cover Noetic. Otherwise
# the build folder gets its own: an update for Noetic alone removes all other distributions from the rules of the user.
find_rosdep_rules()
{
  local output user_home=${CALLER_ROS_HOME:-~/.ros}
  command -v rosdep > /dev/null ||
    die "rosdep is not installed; run these commands as root, then this script again:" \
      "apt-get update; apt-get install python3-rosdep; rosdep init"
  for rosdep_home in "$user_home" "$ROS_HOME"; do
    ! run_rosdep where-defined --rosdistro noetic roscpp > /dev/null 2>&1 || return 0
  done
  log "[1/3] rosdep has no rules for Noetic yet: rosdep ${rosdep_update[*]}"
  output=$(run_rosdep "${rosdep_update[@]}" 2>&1) && return 0
  printf '%s\n' "$output" >&2
  [[ $output != *"rosdep init"* ]] ||
    die "rosdep is not initialised; run this command as root, then this script again: rosdep init"
  die "rosdep could not download its rules; this requires access to the servers in the message above"
}

# rosdep_packages KEY...: prints the packages that package.xml requires and that are not installed, without those of the keys.
rosdep_packages()
{
  local commands other
  commands=$(run_rosdep install --simulate --from-paths "$root" --ignore-src --rosdistro noetic --default-yes \
    --skip-keys "$*") ||
    die "rosdep found no package for some dependencies of package.xml. Its rules may be out of date; run this command, then" \
      "this script again: rosdep ${rosdep_update[*]}"
  # rosdep prints its commands with an indent of two blanks.
  other=$(sed --quiet --regexp-extended '/^  (sudo -H )?apt-get install -y [^ ]+$/d; s/^  //p' <<< "$commands")
  [[ -z $other ]] || die "run these commands of rosdep, then this script again:"$'\n'"$other"
  sed --quiet 's/^  .*apt-get install -y //p' <<< "$commands"
}
