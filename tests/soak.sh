#!/usr/bin/env bash
#
# Uses the programs as nobody should, for as long as you like: sliders, keys, sizes and hitches at
# random, and a million frames. No part of the tests, which it would make last for hours.
#
#     tests/soak.sh [minutes for each step, 10] [pytest options, such as -k step06]

set -euo pipefail

root=$(dirname "$(dirname "$(readlink -f -- "$0")")")
# shellcheck source=common/install.sh disable=SC1091
source "$root/common/install.sh"

minutes=10
if [[ ${1:-} =~ ^[0-9]+$ ]]; then
    minutes=$1
    shift
fi

install_missing build headless test

say "Building in $root/build ..."
quietly cmake -S "$root" -B "$root/build" -DCMAKE_BUILD_TYPE=Release -DSNOWFALL_TESTS=ON
quietly cmake --build "$root/build" --parallel "$(nproc)"

exec env SOAK_MINUTES="$minutes" xvfb-run -a -s "-screen 0 1280x1024x24 +extension GLX -noreset" \
    pytest-3 "$root/tests/soak.py" -q -s -p no:cacheprovider --build="$root/build" \
    --basetemp="$root/build/tests/soak" "$@"
