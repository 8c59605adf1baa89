# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Sourced by demo and pictures, after environment.bash. Runs programs in the background and writes their output to files in
# the folder $out. Provides a virtual screen, and a node and rviz with their own ROS master.

: "${root:?}" "${build:?}" "${out:?}"
started=()  # leaders of the process groups that end_all ends

# set_up TARGET: builds the target and empties the output folder.
set_up()
{
  log "setting up"
  "$root/scripts/setup" "$1"
  source_setup "$build/devel/setup.bash"
  rm -rf "$out"
  mkdir -p "$out"
}

# start NAME COMMAND...: starts a command in a new process group, with its output in $out/NAME.log.
start()
{
  local file=$out/$1.log
  shift
  setsid "$@" > "$file" 2>&1 &
  started+=($!)
}

group_runs()
{
  kill -0 -- "-$1" 2> /dev/null
}

# Ends all process groups, if necessary with SIGKILL.
end_all()
{
  local signal leader
  for signal in INT TERM KILL; do
    for leader in "${started[@]}"; do
      kill "-$signal" -- "-$leader" 2> /dev/null || true
    done
    wait_for 10 none_runs && return
  done
}

none_runs()
{
  local leader
  for leader in "${started[@]}"; do
    ! group_runs "$leader" || return 1
  done
}

# wait_for SECONDS COMMAND...: repeats the command until it succeeds; fails after SECONDS.
wait_for()
{
  local end=$((SECONDS + $1))
  shift
  until "$@" > /dev/null 2>&1; do
    [[ $SECONDS -lt $end ]] || return 1
    sleep 0.2
  done
}

# Prints the ends of all logs and an error message, then exits.
fail()
{
  printf '\n' >&2
  tail --lines=15 "$out"/*.log >&2 || true
  die "$*"
}

start_virtual_screen()
{
  start screen Xvfb -displayfd 1 -screen 0 1280x720x24 -nolisten tcp
  wait_for 20 grep --line-regexp '[0-9][0-9]*' "$out/screen.log" || fail "the virtual screen did not start"
  DISPLAY=:$(grep --line-regexp '[0-9][0-9]*' "$out/screen.log")
  export DISPLAY
}

# Sets ROS_MASTER_URI to a free port, so a ROS master that is already running is not disturbed.
choose_master()
{
  port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("localhost", 0)); print(s.getsockname()[1])')
  export ROS_MASTER_URI=http://localhost:$port
}

# subscribed TOPIC NODE: succeeds if a node whose name starts with NODE has subscribed to the topic.
subscribed()
{
  rostopic info "$1" | sed '1,/^Subscribers/d' | grep --quiet " /$2"
}

# start_node FILE: starts the ROS master and the node with a parameter file, and waits for its subscriptions.
start_node()
{
  start node roslaunch --port="$port" wheel_rail_contact contact.launch config:="$1"
  wait_for 60 subscribed /wheelset/load contact_node || fail "the node did not start"
}

# start_view TOPIC ARGUMENT...: starts rviz and waits until it has subscribed to this topic of the node.
start_view()
{
  local topic=$1
  shift
  start view roslaunch wheel_rail_contact view.launch "$@"
  wait_for 60 subscribed "/contact_node/$topic" contact_view || fail "rviz did not start"
}
