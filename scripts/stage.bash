# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Sourced by demo and pictures after environment.bash: programs in the background, with their output in files of the
# folder $out; a virtual screen; node and rviz with a master of their own.

: "${root:?}" "${build:?}" "${out:?}"
started=()  # leaders of the process groups to end

# set_up [TARGET]: builds the target (default: all programs) and empties the output folder.
set_up()
{
  say "setting up"
  "$root/scripts/setup" "$@"
  source_setup "$build/devel/setup.bash"
  rm -rf "$out"
  mkdir -p "$out"
}

# Starts a command in a process group of its own, with its output in a file.
start()
{
  local log=$out/$1.log
  shift
  setsid "$@" > "$log" 2>&1 &
  started+=($!)
}

group_runs()
{
  kill -0 -- "-$1" 2> /dev/null
}

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

# Repeats a command until it succeeds, for at most so many seconds.
wait_for()
{
  local end=$((SECONDS + $1))
  shift
  until "$@" > /dev/null 2>&1; do
    [[ $SECONDS -lt $end ]] || return 1
    sleep 0.2
  done
}

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

# A master of its own on a free port: one that runs already is not disturbed.
choose_master()
{
  port=$(python3 -c 'import socket; s = socket.socket(); s.bind(("localhost", 0)); print(s.getsockname()[1])')
  export ROS_MASTER_URI=http://localhost:$port
}

subscribed()
{
  rostopic info "$1" | sed '1,/^Subscribers/d' | grep --quiet " /$2"
}

# start_node CONFIG: the node with a file of config/, ready for pairs, and the master.
start_node()
{
  start node roslaunch --port="$port" wheel_rail_contact contact.launch config:="$root/config/$1"
  wait_for 60 subscribed /wheelset/load contact_node || fail "the node did not start"
}

# start_view TOPIC ARGUMENT...: rviz, ready for the node's answers or markers.
start_view()
{
  local topic=$1
  shift
  start view roslaunch wheel_rail_contact view.launch "$@"
  wait_for 60 subscribed "/contact_node/$topic" contact_view || fail "rviz did not start"
}
