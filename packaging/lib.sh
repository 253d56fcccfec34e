# shellcheck shell=bash
# What packaging/run, packaging/test, … and .ci/run share. Sourced, never run.

set -euo pipefail
root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
logs=$root/build/log
mkdir -p "$logs"
# Another checkout of the same sources finds what this one compiled.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1

fail() {
  printf '%s\n' "$*" >&2
  exit 1
}

# logged LOG DOING COMMAND…: runs COMMAND with its output in build/log/LOG.log and returns its status.
# On a terminal one line tells meanwhile what it is doing.
logged() {
  local log=$logs/$1.log doing=$2 ticker='' status=0
  shift 2
  if [[ -t 1 ]]; then
    showProgress "$log" "$doing" &
    ticker=$!
  fi
  "$@" </dev/null >"$log" 2>&1 || status=$?
  if [[ -n $ticker ]]; then
    kill "$ticker"
    wait "$ticker" 2>/dev/null || true
    printf '\r\e[K'
  fi
  return "$status"
}

# Shows DOING and the last line of LOG until it is killed, or until the script that started it is gone.
showProgress() {
  local columns
  columns=$(tput cols 2>/dev/null || echo 80)
  while kill -0 $$ 2>/dev/null; do
    printf '\r\e[K%.*s' "$((columns - 1))" "$2 … $(tail -n 1 "$1" 2>/dev/null | tr -d '\r')"
    sleep 0.3
  done
}

# mustPass LOG DOING COMMAND…: like logged; on failure shows the end of the log and ends the script.
mustPass() {
  logged "$@" && return
  local lines=40
  [[ ${CI:-} != true ]] || lines=400
  tail -n "$lines" "$logs/$1.log" >&2
  fail "$2 failed. The whole log: $logs/$1.log"
}

# ensurePackages LIST…: installs the Debian packages of the lists that are not installed yet.
ensurePackages() {
  # On another system the build itself names what it lacks.
  command -v dpkg-query >/dev/null || return 0
  local wanted installed missing
  wanted=$(grep -hv '^#' "$@" | sort)
  # shellcheck disable=SC2086  # one word a package
  installed=$(dpkg-query --show --showformat='${db:Status-Abbrev}${Package}\n' $wanted 2>/dev/null |
    sed -n 's/^ii *//p' | sort -u || true)
  mapfile -t missing < <(comm -23 <(echo "$wanted") <(echo "$installed"))
  if ((${#missing[@]})); then
    installPackages "${missing[@]}"
  fi
}

installPackages() {
  local asRoot=()
  if ((EUID != 0)); then
    command -v sudo >/dev/null || fail "As root, first run: apt-get install $*"
    sudo -v || fail "As root, first run: apt-get install $*"
    asRoot=(sudo)
  fi
  local apt=("${asRoot[@]}" env DEBIAN_FRONTEND=noninteractive apt-get --quiet --yes
    --option DPkg::Lock::Timeout=300)
  local install=("${apt[@]}" install --no-install-recommends "$@")
  # Package lists that are absent or too old are the usual reason for a first failure.
  logged install "Installing $# packages" "${install[@]}" && return
  mustPass update "Fetching the package lists" "${apt[@]}" update
  mustPass install "Installing $# packages" "${install[@]}"
}

# The build directory of a preset of CMakePresets.json.
buildDirectory() {
  if [[ $1 == release ]]; then echo "$root/build"; else echo "$root/build-$1"; fi
}

# buildPreset PRESET [TARGET…]: configures when that is due, and builds.
buildPreset() {
  local preset=$1 directory configure=(cmake -S "$root" --preset "$1") targets=()
  shift
  directory=$(buildDirectory "$preset")
  # The directory of a checkout that was moved is configured afresh.
  if ! grep -qsxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$directory/CMakeCache.txt"; then
    configure+=(--fresh)
  fi
  if [[ ${configure[-1]} == --fresh || $root/CMakePresets.json -nt $directory/build.ninja ]]; then
    mustPass "configure-$preset" "Configuring ($preset)" "${configure[@]}"
  fi
  (($# == 0)) || targets=(--target "$@")
  mustPass "build-$preset" "Building ($preset)" cmake --build "$directory" "${targets[@]}"
}
