# Sourced by the other scripts: building without noise.
# shellcheck shell=bash

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
# shellcheck disable=SC2034 # for those who source this
build=$root/build

# Runs a command; its output goes to the file LOG and is shown only if it fails.
quietly() { # LOG COMMAND...
  local log=$1 status=0
  shift
  "$@" >"$log" 2>&1 </dev/null || status=$?
  if ((status != 0)); then
    cat "$log" >&2
    echo "failed ($status): $*" >&2
    return 1 # other numbers mean something to some callers
  fi
}

configure() { # DIR [CMAKE_OPTION...]
  local dir=$1
  shift
  mkdir -p "$dir"
  quietly "$dir/configure.log" cmake -S "$root" -B "$dir" -DABF_INSTALL_CORE=OFF -DABF_PROGRAM_PARTS=all \
    -DABF_WARNINGS_AS_ERRORS="$([[ ${CI:-} == true ]] && echo ON || echo OFF)" "$@"
}

compile() { # DIR [CMAKE_BUILD_OPTION...]
  local dir=$1
  shift
  quietly "$dir/build.log" cmake --build "$dir" --parallel "${CMAKE_BUILD_PARALLEL_LEVEL:-$(parallel_jobs)}" "$@"
}

# Runs all tests, and in CI, fails if one was skipped. Only the reference disks, which are beside the checkout, need not be
# there.
run_tests() { # DIR [CTEST_OPTION...]
  local dir=$1 skipped
  shift
  ctest --test-dir "$dir" --output-on-failure --no-tests=error \
    --parallel "${CTEST_PARALLEL_LEVEL:-$(nproc)}" "$@" | tee "$dir/test.log" || return
  [[ ${CI:-} == true ]] || return 0
  skipped=$(sed -n 's/^.* - \([^ ]*\) (\(Skipped\|Disabled\|Not Run\)).*/\1/p' "$dir/test.log")
  if [[ ! -d $root/../shared/data ]]; then
    skipped=$(sed '/_of_reference_disks$/d' <<<"$skipped")
  fi
  if [[ -n $skipped ]]; then
    printf 'skipped, though what they need should be there:\n%s\n' "$skipped" >&2
    return 1
  fi
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
