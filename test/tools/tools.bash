# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Sourced by the checks: source and build folders, and what every check needs.
set -euo pipefail
source_dir=$(cd "$1" && pwd)
mkdir -p "$2"
build_dir=$(cd "$2" && pwd)
cd "$source_dir"

# Ends as skipped unless the command is there and, if a version is given, is that version.
require()
{
  local command=$1 version=${2:-}
  if ! command -v "$command" > /dev/null; then
    echo "skipped: $command is not installed"
    exit 77
  fi
  if [[ -n $version ]] && ! "$command" --version | grep --quiet "version $version\."; then
    echo "skipped: needs $command $version, found: $("$command" --version | head --lines=1)"
    exit 77
  fi
}

cpp_files()
{
  find include src test -name '*.h' -print0 -o -name '*.cpp' -print0 | sort --zero-terminated
}

# Files whose first line names the given interpreter, and those with the given suffix.
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

# A list of paths separated by colons, without those in the build folder.
without_build_dir()
{
  tr ':' '\n' <<< "$1" | grep --invert-match --fixed-strings "$build_dir" | paste --serial --delimiters=: || true
}

# A folder for the check, gone with it. Not in the build folder: that lies inside the package, where roslaunch and rosrun
# would find what is copied or linked there.
make_scratch_dir()
{
  scratch_dir=$(mktemp --directory)
  trap 'rm -rf "$scratch_dir"' EXIT
}
