#!/usr/bin/env bash
#
# Installs what is missing, builds everything and runs all the tests.
#
#     tests/run.sh [--sanitize] [ctest options]
#
# --sanitize builds, in a folder of its own, with the address and undefined behaviour sanitizers.
# One test more runs at a time than there are cores, as some wait for windows; "-j 1" runs one after
# the other.

set -euo pipefail

root=$(dirname "$(dirname "$(readlink -f -- "$0")")")
# shellcheck source=common/install.sh disable=SC1091
source "$root/common/install.sh"

build=$root/build
sanitize=OFF
if [[ ${1:-} == --sanitize ]]; then
    build=$root/build-sanitize
    sanitize=ON
    shift
fi

install_missing build headless compare test

say "Building in $build ..."
quietly cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DSNOWFALL_TESTS=ON \
    -DSNOWFALL_SANITIZE="$sanitize"
quietly cmake --build "$build" --parallel "$(nproc)"

exec ctest --test-dir "$build" --no-tests=error --output-on-failure --parallel $(($(nproc) + 1)) "$@"
