#!/usr/bin/env bash
#
# Installs what is missing, builds everything and runs all the tests.
#
#     tests/run.sh [--sanitize] [ctest options]
#     tests/run.sh --driver [pytest options]
#
# --sanitize builds, in a folder of its own, with the address and undefined behaviour sanitizers.
# One test more runs at a time than there are cores, as some wait for windows; "-j 1" runs one after
# the other.
# --driver runs the programs' tests, one after the other, on the OpenGL and the display that are there,
# in place of Mesa's in software: do not touch mouse or keyboard meanwhile. It skips what only that
# promises, and ends with a table to paste into an issue.

set -euo pipefail

root=$(dirname "$(dirname "$(readlink -f -- "$0")")")
# shellcheck source=common/install.sh disable=SC1091
source "$root/common/install.sh"
# shellcheck source=common/build.sh disable=SC1091
source "$root/common/build.sh"

build=$root/build
sanitize=OFF
if [[ ${1:-} == --sanitize ]]; then
    build=$root/build-sanitize
    sanitize=ON
    shift
fi

driver=false
if [[ ${1:-} == --driver ]]; then
    driver=true
    shift
fi

check_build_folder "$build"
install_missing build headless compare test
build_in "$build" -DSNOWFALL_TESTS=ON -DSNOWFALL_SANITIZE="$sanitize"

if $driver; then
    display=()
    [[ -n ${DISPLAY:-} ]] || display=(xvfb-run -a -s "-screen 0 1280x1024x24 +extension GLX -noreset")
    # No test of other things than programs.
    PYTHONDONTWRITEBYTECODE=1 exec "${display[@]}" pytest-3 "$root/tests" --driver --build="$build" \
        --basetemp="$build/tests/driver" -p no:cacheprovider -q --ignore="$root/tests/common/compare" \
        --ignore-glob="*test_chapters*" --ignore-glob="*test_glsl*" --ignore-glob="*test_run_script*" "$@"
fi

exec ctest --test-dir "$build" --no-tests=error --output-on-failure --parallel $(($(nproc) + 1)) "$@"
