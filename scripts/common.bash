# Sourced by the other scripts: how everything is configured, compiled and tested.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck disable=SC2034 # for those who source this
build=$root/build

fail() { # SENTENCE
  echo "$(basename "$0"): $*" >&2
  exit 1
}

# Ends the script with the output of a command that failed, and with the reason in the last line.
fail_with_log() { # LOG SENTENCE
  cat "$1" >&2
  if (($(df --output=avail "$build" | tail -n 1) < 20000)) || grep -q 'No space left on device' "$1"; then
    fail "the disk is full: make room for $build and try again"
  fi
  fail "$2"
}

# Runs a command; its output goes to the file LOG and is shown only if it fails.
quietly() { # LOG COMMAND...
  local log=$1 status=0
  shift
  "$@" >"$log" 2>&1 </dev/null || status=$?
  ((status == 0)) || fail_with_log "$log" "failed ($status): $*"
}

configure() { # DIR [CMAKE_OPTION...]
  local dir=$1
  shift
  mkdir -p "$dir" || fail "there can be no folder $dir"
  quietly "$dir/configure.log" cmake -S "$root" -B "$dir" -DABF_INSTALL_CORE=OFF -DABF_PROGRAM_PARTS=all "$@"
}

compile() { # DIR [CMAKE_BUILD_OPTION...]
  local dir=$1
  shift
  cmake --build "$dir" --parallel "${CMAKE_BUILD_PARALLEL_LEVEL:-$(parallel_jobs)}" "$@" 2>&1 </dev/null |
    tee "$dir/build.log" | show_progress || fail_with_log "$dir/build.log" "could not be built: see $dir/build.log"
}

# Reads the output of a build, and tells how far it has come. Says nothing where there is nothing to build.
show_progress() {
  local line status what=
  while true; do
    status=0
    IFS= read -r -t 1 line || status=$?
    if ((status == 0)); then
      [[ $line =~ ^\[\ *([0-9]+%|[0-9]+/[0-9]+)\]\ (Building|Linking).*[\ /]([^/ ]+)$ ]] || continue
      [[ $what ]] || echo "building (some minutes the first time)..." >&2
      what="${BASH_REMATCH[1]} ${BASH_REMATCH[2],,} ${BASH_REMATCH[3]%.o}"
      [[ -t 2 ]] || echo "  $what" >&2
    elif ((status < 128)); then
      break
    fi
    [[ -t 2 && $what ]] && printf '\r\033[K  %s (%d s)' "$what" "$SECONDS" >&2
  done
  if [[ -t 2 && $what ]]; then echo >&2; fi
}

# Sets `processor_seconds` to the processor time of all commands that have ended.
count_processor_seconds() {
  local file
  file=$(mktemp)
  times >"$file" # not in a subshell, which has run no command
  processor_seconds=$(awk 'NR == 2 { gsub(/[ms]/, " "); print int($1 * 60 + $2 + $3 * 60 + $4) }' "$file")
  rm "$file"
}

# Sets `wheel_python` to a Python with what packs and checks wheels.
install_wheel_tools() {
  local tools=$build/wheel_tools
  wheel_python=$tools/bin/python
  if ! cmp -s "$root/python/requirements.txt" "$tools/requirements.txt"; then
    rm -rf "$tools"
    quietly "$build/wheel_tools.log" /usr/bin/python3 -m venv "$tools"
    quietly "$build/wheel_tools.log" "$tools/bin/pip" install --disable-pip-version-check -r "$root/python/requirements.txt"
    cp "$root/python/requirements.txt" "$tools" # at last, so that what is half installed is installed again
  fi
}

run_tests() { # DIR [CTEST_OPTION...]
  local dir=$1
  shift
  ctest --test-dir "$dir" --output-on-failure --no-tests=error \
    --parallel "${CTEST_PARALLEL_LEVEL:-$(nproc)}" "$@" | tee "$dir/test.log"
}

# For CI. Only the reference disks, which may be in a folder beside the checkout, need not be there.
fail_if_skipped() { # DIR
  local skipped
  skipped=$(sed -n 's/^.* - \([^ ]*\) (\(Skipped\|Disabled\|Not Run\)).*/\1/p' "$1/test.log")
  if [[ ! -d $root/../shared/data ]]; then
    skipped=$(sed '/_of_reference_disks$/d' <<<"$skipped")
  fi
  [[ -z $skipped ]] || fail "skipped, though what they need should be there: ${skipped//$'\n'/ }"
}

# As many as there are cores, but compiling a file of CGAL takes up to 2 GB of memory.
parallel_jobs() {
  local cores memory limit
  cores=$(nproc)
  memory=$(awk '/^MemAvailable/ { print int($2 / 1024) }' /proc/meminfo)
  if [[ -r /sys/fs/cgroup/memory.max ]]; then
    limit=$(</sys/fs/cgroup/memory.max)
    if [[ $limit != max ]] && ((limit / 1048576 < memory)); then
      memory=$((limit / 1048576))
    fi
  fi
  local jobs=$((memory / 2000))
  echo $((jobs < 1 ? 1 : jobs < cores ? jobs : cores))
}
