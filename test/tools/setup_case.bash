# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Sourced by check_setup, after tools.bash. Runs scripts/setup with stubs of apt, sudo and cmake. rosdep is real, with local
# rules.

: "${source_dir:?}" "${scratch_dir:?}"
stubs=$source_dir/test/tools/stub_programs
rosdep=$(command -v rosdep)

# The programs that setup requires, without those of package management.
link_programs()
{
  local program
  mkdir "$scratch_dir/programs"
  for program in awk bash cat cmp comm cp dirname env flock grep head ln mkdir nproc paste python3 rm sed sort tr; do
    ln --symbolic "$(command -v "$program")" "$scratch_dir/programs/"
  done
}

# Writes rules of rosdep: an index with Noetic as an end-of-life distribution, and the rules for other packages.
write_rules()
{
  local rules=$source_dir/test/tools/rosdep.yaml
  mkdir "$scratch_dir/sources" "$scratch_dir/no_sources"
  # The public rules do not contain the keys that setup skips.
  grep --invert-match --extended-regexp 'ros-noetic-|^(calculix-ccx|gmsh|python3-distributed):' "$rules" \
    > "$scratch_dir/rules.yaml"
  echo "yaml file://$scratch_dir/rules.yaml" > "$scratch_dir/sources/10.list"
  cat > "$scratch_dir/index.yaml" << END
distributions:
  noetic: {distribution: [noetic.yaml], distribution_status: end-of-life, distribution_type: ros1, python_version: 3}
type: index
version: 4
END
  {
    printf 'type: distribution\nversion: 2\nrelease_platforms: {ubuntu: [focal]}\nrepositories:\n'
    sed --quiet --regexp-extended \
      's/^(\w+): .*ros-noetic-.*/  \1: {release: {tags: {release: none}, url: none, version: 1.0.0-1}}/p' "$rules"
  } > "$scratch_dir/noetic.yaml"
}

# update_rules HOME ARGUMENT...: runs the real rosdep update with this ROS_HOME.
update_rules()
{
  ROS_HOME=$1 ROSDEP_SOURCE_PATH=$scratch_dir/sources ROSDISTRO_INDEX_URL=file://$scratch_dir/index.yaml \
    rosdep update "${@:2}" > "$scratch_dir/log" 2>&1 || { cat "$scratch_dir/log"; exit 1; }
}

# substitute FILE OLD NEW: replaces a text, which the file must contain.
substitute()
{
  local text
  text=$(< "$1")
  [[ $text == *"$2"* ]] || { echo "$1 does not contain: $2"; exit 1; }
  printf '%s\n' "${text//"$2"/"$3"}" > "$1"
}

# begin NAME: prepares a case: root on Ubuntu 20.04 with ROS Noetic, which no shell has sourced, and rosdep with rules for it.
begin()
{
  case_name=$1
  case_dir=$(mktemp --directory "$scratch_dir/case.XXX")
  package=$case_dir/package
  noetic=$case_dir/noetic
  home=$case_dir/home
  variables=()
  mkdir --parents "$package" "$noetic" "$home" "$case_dir/state" "$case_dir/path"
  cp --recursive package.xml scripts "$package"
  # The scripts of the package put the programs of the system first in PATH, and read its name.
  # shellcheck disable=SC2016
  substitute "$package/scripts/environment.bash" 'PATH=/usr/bin:/bin:/usr/sbin:/sbin:$PATH' 'PATH'
  substitute "$package/scripts/setup" /etc/os-release "$case_dir/os-release"
  touch "$noetic/.catkin"
  echo "export ROS_DISTRO=noetic CMAKE_PREFIX_PATH=$noetic" > "$noetic/setup.bash"
  cp --recursive "$scratch_dir/noetic_rules" "$home/.ros"
  system ubuntu 20.04
  cp "$stubs"/* "$case_dir/path"
  : > "$case_dir/state/installed"
  : > "$case_dir/state/new"
  : > "$case_dir/state/absent"
  echo Packages > "$case_dir/state/lists"
  echo 0 > "$case_dir/state/user"
  echo 0 > "$case_dir/state/failures"
}

# system ID VERSION
system()
{
  printf 'ID=%s\nVERSION_ID="%s"\n' "$1" "$2" > "$case_dir/os-release"
}

# set_state FILE LINE...: see stub_programs/apt-get for the files.
set_state()
{
  printf '%s\n' "${@:2}" > "$case_dir/state/$1"
}

without_program()
{
  rm "$case_dir/path/$1"
}

# run [COMMAND...]: runs scripts/setup, or another command, in a clean environment with the array variables.
run()
{
  [[ $# -gt 0 ]] || set -- "$package/scripts/setup"
  : > "$case_dir/state/commands"
  status=0
  env --ignore-environment LANGUAGE=de PATH="$case_dir/path:$scratch_dir/programs" HOME="$home" STATE="$case_dir/state" ROSDEP="$rosdep" \
    NOETIC_PREFIX="$noetic" ROSDEP_SOURCE_PATH="$scratch_dir/sources" ROSDISTRO_INDEX_URL="file://$scratch_dir/index.yaml" \
    ROS_OS_OVERRIDE=ubuntu:20.04:focal "${variables[@]}" "$@" > "$case_dir/output" 2>&1 || status=$?
}

# fail_case TEXT: reports a failed case, and ends the check.
fail_case()
{
  echo "case '$case_name': $1; exit status $status, output and commands:"
  cat "$case_dir/output" "$case_dir/state/commands"
  exit 1
}

expect_success()
{
  [[ $status -eq 0 ]] || fail_case "setup failed"
}

# expect_failure TEXT: setup fails with an error message that contains the text.
expect_failure()
{
  [[ $status -eq 1 ]] || fail_case "setup did not fail"
  grep "^setup: " "$case_dir/output" | grep --quiet --fixed-strings -- "$1" || fail_case "no message '$1'"
}

expect_output()
{
  grep --quiet --fixed-strings -- "$1" "$case_dir/output" || fail_case "no output '$1'"
}

# expect_command PATTERN: exactly one command matches the regular expression.
expect_command()
{
  [[ $(grep --count -- "$1" "$case_dir/state/commands") -eq 1 ]] || fail_case "not one command '$1'"
}

expect_no_command()
{
  ! grep --quiet -- "$1" "$case_dir/state/commands" || fail_case "a command '$1'"
}

# expect_order PATTERN PATTERN: exactly one command matches each pattern, the one of the first pattern earlier.
expect_order()
{
  local earlier later
  expect_command "$1"
  expect_command "$2"
  earlier=$(grep --line-number -- "$1" "$case_dir/state/commands")
  later=$(grep --line-number -- "$2" "$case_dir/state/commands")
  [[ ${earlier%%:*} -lt ${later%%:*} ]] || fail_case "'$2' is not after '$1'"
}
