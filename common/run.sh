#!/usr/bin/env bash
#
# Installs what is missing, builds what has changed and runs one step. See usage below.
#
# The bash of macOS (3.2) must get as far as the line that says what to do there: it knows no
# negative indices, and takes an empty array for an unset variable.

set -euo pipefail

root=$(dirname "$(dirname "$(readlink -f -- "$0")")")
# shellcheck source=common/install.sh disable=SC1091
source "$root/common/install.sh"
# shellcheck source=common/build.sh disable=SC1091
source "$root/common/build.sh"

# Every step's folder has the name of its program.
steps=()
for folder in "$root"/step[0-9][0-9]_*/; do
    steps+=("$(basename "$folder")")
done

usage()
{
    cat <<END
Usage: common/run.sh [step] [options]

Builds Snowfall and runs one of its steps, or the last one.

  step      1 to ${#steps[@]}, or a name:
$(printf '                %s\n' "${steps[@]}")
            or 'compare', to run all of them against each other
  options   are passed on; 'common/run.sh 6 --help' lists those of step 6

Without a display the program draws 90 frames in memory, 20 times as fast as in a window, and
saves the last as a picture.
END
}

# What to run: the first argument, unless it is an option already.
target=${steps[${#steps[@]} - 1]}
if (($# > 0)) && [[ $1 != -* ]]; then
    target=
    for step in "${steps[@]}"; do
        number=${step:4:2}
        # A trailing slash comes from completing the folder's name in the shell.
        case ${1%/} in
            "$step" | "step$number" | "step${number#0}" | "$number" | "${number#0}") target=$step ;;
            compare) target=compare ;;
        esac
    done
    if [[ -z $target ]]; then
        say "There is no step '$1', only: 1 to ${#steps[@]} (${steps[*]}) and compare."
        exit 2
    fi
    shift
elif [[ ${1:-} == -h || ${1:-} == --help ]]; then
    usage
    exit
fi

# freeglut draws on X11, so DISPLAY tells, on a Wayland desktop too (there Xwayland sets it).
headless=false
if [[ -z ${DISPLAY:-} ]]; then
    headless=true
fi

# Nobody can see the window or close it, so stop after a while and leave a picture, unless the
# options already say what is to come of it.
picture=
timelapse=20
if $headless && [[ $target != compare ]]; then
    picture=$PWD/snowfall_${target%%_*}.png
    for option in "$@"; do
        case $option in
            --timelapse*) timelapse= ;;
            --frames* | --benchmark* | --screenshot* | --dump* | --help* | -h) picture= ;;
        esac
    done
fi

# Said now, not after minutes of installing, building and drawing.
if [[ -n $picture ]] && ! writable "$picture"; then
    say "The picture $picture cannot be written. Please start this in a folder of your own."
    exit 1
fi
check_build_folder "$root/build"

groups=(build)
if $headless; then groups+=(headless); fi
if [[ $target == compare ]]; then groups+=(compare); fi
install_missing "${groups[@]}"

build_in "$root/build" -DSNOWFALL_TESTS=OFF

if [[ $target == compare ]]; then
    # Debian's own, which has the packages just installed; the first in PATH may be another.
    command=(/usr/bin/python3 "$root/common/compare/compare.py" "$@")
else
    command=("$root/build/$target" "$@")
fi

if ! $headless; then
    exec "${command[@]}"
fi

if [[ -n $picture ]]; then
    command+=(${timelapse:+--timelapse "$timelapse"} --frames 90 --screenshot "$picture")
    say "There is no display: drawing 90 frames in memory ..."
fi

status=0
xvfb-run -a -s "-screen 0 2560x1440x24" "${command[@]}" || status=$?
if ((status > 128)); then
    say "$target was ended by a signal (exit status $status)."
elif ((status == 0)) && [[ -n $picture ]]; then
    say "The last frame is in $picture"
fi
exit "$status"
