# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Sourced by the checks. Arguments: source and build folders. Provides functions that several checks use.
set -euo pipefail
source_dir=$(cd "$1" && pwd)
mkdir -p "$2"
build_dir=$(cd "$2" && pwd)
cd "$source_dir"

# require COMMAND [VERSION]: exits as skipped if the command is not installed or has another version.
require()
{
  local command=$1 version=${2:-}
  if ! command -v "$command" > /dev/null; then
    echo "skipped: $command is not installed"
    exit 77
  fi
  if [[ -n $version ]] && ! "$command" --version | grep --quiet "version $version\."; then
    echo "skipped: requires $command $version, found: $("$command" --version | head --lines=1)"
    exit 77
  fi
}

# oldest_version SOFTWARE: prints the oldest supported version, which doc/platforms.md states.
oldest_version()
{
  sed --quiet "s/^| $1 | \([0-9.]*\) |.*/\1/p" doc/platforms.md | grep . ||
    { echo "doc/platforms.md does not state the oldest version of $1" >&2; return 1; }
}

cpp_files()
{
  find include src test -name '*.h' -print0 -o -name '*.cpp' -print0 | sort --zero-terminated
}

# files_for INTERPRETER SUFFIX: files with this suffix, and files whose first line contains the interpreter.
files_for()
{
  local interpreter=$1 suffix=$2
  find scripts src test .ci -type f \( -name "*.$suffix" -o -perm /111 \) -print0 | sort --zero-terminated |
    while IFS= read -r -d '' file; do
      if [[ $file == *.$suffix ]] || head --lines=1 "$file" | grep --quiet --text "^#!.*$interpreter"; then
        printf '%s\0' "$file"
      fi
    done
}

# without_build_dir PATHS: a list of paths separated by colons, without those in the build folder.
without_build_dir()
{
  tr ':' '\n' <<< "$1" | grep --invert-match --fixed-strings "$build_dir" | paste --serial --delimiters=: || true
}

# Creates a temporary folder, which is removed when the check ends. It is not in the build folder, because this is inside the
# package: roslaunch and rosrun would find copies and links in it.
make_scratch_dir()
{
  scratch_dir=$(mktemp --directory)
  trap 'rm -rf "$scratch_dir"' EXIT
}
