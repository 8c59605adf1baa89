# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Sourced by the scripts of this folder. Provides functions that create the system of another distribution in a folder, and run
# commands in it. Requires root and debootstrap.

source_dir=$(cd -P "$(dirname "${BASH_SOURCE[0]}")/../.." > /dev/null && pwd)
# Outside the package: roslaunch and rosrun would find the packages of these systems.
platforms_dir=${PLATFORMS_DIR:-${XDG_CACHE_HOME:-$HOME/.cache}/wheel_rail_contact/platforms}
package_dir=/opt/wheel_rail_contact  # of the package, in the other system

# mirror_of LABEL: the first mirror of a distribution in the configuration of apt, if any.
mirror_of()
{
  # shellcheck disable=SC2016
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' "Label: $1" | sed -n '1s|/$||p'
}

debian=${DEBIAN_MIRROR:-$(mirror_of Debian)}
ubuntu=${UBUNTU_MIRROR:-$(mirror_of Ubuntu)}
ubuntu_keyring=/usr/share/keyrings/ubuntu-archive-keyring.gpg
# Ubuntu Archive Automatic Signing Keys of 2012 and 2018, as published by Ubuntu.
ubuntu_keys=(790BC7277767219C42C86F933B4FE6ACC0B21F32 F6ECB3762474EDA9D21B7022871920D1991BC93C)

log()
{
  printf '\n== %s\n' "$*" >&2
}

die()
{
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}

# Sets mirror, lists and keyring for the name of a release.
choose_release()
{
  case $1 in
    bullseye | bookworm | trixie)
      mirror=$debian
      components=main
      keyring=/usr/share/keyrings/debian-archive-keyring.gpg
      lists=("deb $debian $1 main")  # without security updates: those of old releases are no longer complete
      ;;
    focal | jammy)
      mirror=$ubuntu
      components=main,universe
      keyring=$ubuntu_keyring
      lists=("deb $ubuntu $1 main universe" "deb $ubuntu $1-updates main universe")
      ;;
    *) die "unknown release '$1'; known: bullseye bookworm trixie focal jammy" ;;
  esac
  [[ -n $mirror ]] || die "apt has no mirror of this distribution; give it by DEBIAN_MIRROR or UBUNTU_MIRROR"
}

# Debian does not always have the package of Ubuntu's keys. Ubuntu's own package is accepted if it contains exactly these keys.
download_ubuntu_keyring()
{
  local package=$ubuntu/pool/main/u/ubuntu-keyring/ubuntu-keyring_2020.02.11.4_all.deb folder=$platforms_dir/ubuntu_keyring key
  ubuntu_keyring=$folder/usr/share/keyrings/ubuntu-archive-keyring.gpg
  if [[ ! -r $ubuntu_keyring ]]; then
    mkdir -p "$folder"
    curl --fail --silent --show-error --output "$folder/keyring.deb" "$package" || die "cannot download $package"
    dpkg-deb --extract "$folder/keyring.deb" "$folder"
  fi
  keyring=$folder/archive.gpg
  rm -f "$keyring"
  for key in "${ubuntu_keys[@]}"; do
    gpg --batch --no-default-keyring --keyring "$ubuntu_keyring" --export "$key" >> "$keyring"
  done
  gpg --batch --show-keys --with-colons "$keyring" | grep --quiet "^fpr:*${ubuntu_keys[1]}:" ||
    die "$package does not contain the signing key ${ubuntu_keys[1]}"
}

# make_root RELEASE FOLDER: creates the minimal system of a release in a folder, unless it is complete.
make_root()
{
  local folder=$2
  [[ $(id -u) -eq 0 ]] || die "requires root: chroot and mount"
  command -v debootstrap > /dev/null || die "requires debootstrap; run: apt-get install debootstrap"
  choose_release "$1"
  [[ ! -e $folder/.complete ]] || return 0
  if [[ $mirror == "$ubuntu" && ! -r $keyring ]]; then
    download_ubuntu_keyring
  fi
  log "creating the minimal system of $1 in $folder"
  rm -rf --one-file-system "$folder"
  mkdir -p "$folder"
  debootstrap --variant=minbase --components="$components" --keyring="$keyring" "$1" "$folder" "$mirror" > "$folder.debootstrap.log" ||
    die "debootstrap failed: $folder.debootstrap.log"
  printf '%s\n' "${lists[@]}" > "$folder/etc/apt/sources.list"
  touch "$folder/.complete"
}

# Ubuntu 20.04 lacks one of the ROS packages, which contains only headers. That of Debian 11 is used.
install_diagnostic_updater()
{
  local folder=$1 name=libdiagnostic-updater-dev_1.10.1+ds1-3_amd64.deb
  local sum=2789285cb32ea016c45d86a61614fa8a9da52e7bd31cb4f0771b643b21d8b0d6
  if in_root "$folder" dpkg --status libdiagnostic-updater-dev > /dev/null 2>&1; then
    return 0
  fi
  curl --fail --silent --show-error --output "$folder/root/$name" "$debian/pool/main/r/ros-diagnostics/$name"
  sha256sum --check --quiet <<< "$sum $folder/root/$name"
  in_root "$folder" apt-get update --quiet
  in_root "$folder" env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends "/root/$name"
}

# in_root FOLDER COMMAND...: runs a command in the other system, with an environment of its own. All its processes, also those
# in the background, end with it. The mounts are invisible outside. The inner bash stays process 1, because it
# reaps orphans: it must not end in exec.
in_root()
{
  local folder=$1
  shift
  cp --dereference /etc/resolv.conf /etc/hosts "$folder/etc/"
  # shellcheck disable=SC2016
  unshare --mount --pid --fork --kill-child bash -c '
    set -e
    mount --bind /dev "$1/dev"
    mount --bind /dev/pts "$1/dev/pts"
    mount --types tmpfs tmpfs "$1/dev/shm"
    mount --types proc proc "$1/proc"
    mount --types sysfs sysfs "$1/sys"
    cd "$1"
    chroot "$@"
    exit $?' bash "$folder" \
    env --ignore-environment HOME=/root LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "$@"
}

# copy_package FOLDER: copies the files of the package that git does not ignore into the other system.
copy_package()
{
  local folder=$1$package_dir
  mkdir -p "$folder"
  # Files that were deleted in the package must not remain. The build folder remains: a second run builds only what changed.
  find "$folder" -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +
  git -C "$source_dir" ls-files -z --cached --others --exclude-standard |
    while IFS= read -r -d '' file; do
      if [[ -e $source_dir/$file ]]; then  # a tracked file may have been deleted
        printf '%s\0' "$file"
      fi
    done |
    tar --create --directory="$source_dir" --null --files-from=- |
    tar --extract --directory="$folder"
}
