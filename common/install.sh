#!/usr/bin/env bash
#
# Installs, with apt-get, the Debian packages that Snowfall needs and that are missing.
#
#     common/install.sh [build] [headless] [compare] [test]      no name: all four groups
#
# common/run.sh and tests/run.sh source this file instead, for its functions. Where nothing is
# missing it changes nothing, prints nothing and never touches the network.

set -euo pipefail

# The one list of packages: prints those of a group, or fails. "a|b": either will do, for a package
# whose name depends on the release. A function, as macOS's bash (3.2) has no associative arrays.
packages_of()
{
    case $1 in
        # A compiler, and the libraries of all six steps.
        build) echo "g++ cmake make pkg-config|pkgconf freeglut3-dev|libglut-dev libglew-dev" \
                    "libglm-dev libstb-dev libcli11-dev libimgui-dev libtinyobjloader-dev" ;;
        # A display in memory, and OpenGL in software, for machines that have neither.
        headless) echo "xvfb xauth libgl1-mesa-dri" ;;
        # common/compare/compare.py.
        compare) echo "python3 python3-matplotlib python3-pandas python3-tqdm" ;;
        # The tests that call the code, and those that look at the pictures and press the keys.
        test) echo "libgtest-dev python3-pytest python3-numpy python3-pil" \
                   "xdotool glslang-tools git" ;;
        *) return 1 ;;
    esac
}

# Messages go to stderr: what the programs print on stdout may be going into a file.
say() { printf '%s\n' "$*" >&2; }

# quietly COMMAND...: runs it and shows its output only if it fails.
quietly()
{
    local output status=0
    output=$("$@" 2>&1) || status=$?
    if ((status != 0)); then
        say "$output"
    fi
    return "$status"
}

# Succeeds if one of the alternatives of "a|b" is installed.
installed()
{
    local states
    # dpkg-query fails for a name it has never seen, but still answers for the others.
    # shellcheck disable=SC2016,SC2086  # ${...} is dpkg-query's; the names are to be split.
    states=$(dpkg-query -W -f '${db:Status-Status}\n' ${1//|/ } 2>/dev/null) || true
    grep -qx installed <<<"$states"
}

# Prints the first alternative of "a|b" that this release offers; fails if it offers none.
available()
{
    local name
    for name in ${1//|/ }; do
        if [[ -n $(apt-cache madison "$name" 2>/dev/null) ]]; then
            echo "$name"
            return
        fi
    done
    return 1
}

# install_missing GROUP...: returns 1, after one line that says what to do, if it cannot.
install_missing()
{
    local group list entry name
    local entries wanted=() missing=() names=() unknown=()

    for group in "$@"; do
        if ! list=$(packages_of "$group"); then
            say "There is no group of packages called '$group'," \
                "only: build, headless, compare and test."
            return 1
        fi
        read -r -a entries <<<"$list"
        wanted+=("${entries[@]}")
    done

    if [[ $OSTYPE == darwin* ]]; then
        say "macOS cannot run Snowfall: the README's table says why."
        return 1
    fi
    if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
        say "This system has no apt-get. Please install by hand what these Debian packages hold" \
            "(${wanted[*]%%|*}), or let vcpkg fetch the libraries (see the README)," \
            "then build and run without this script:" \
            "cmake -B build && cmake --build build && build/step06_accumulation"
        return 1
    fi

    for entry in "${wanted[@]}"; do
        installed "$entry" || missing+=("$entry")
    done
    if ((${#missing[@]} == 0)); then
        return
    fi

    # sudo drops most variables, hence env, which sets this one on sudo's other side.
    local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o DPkg::Lock::Timeout=120)
    local by_hand="apt-get update && apt-get install -y --no-install-recommends"
    if ((EUID != 0)); then
        apt=(sudo "${apt[@]}")
        say "Packages are missing: ${missing[*]}. Installing them takes root: sudo may ask for your password."
        # It may be there and still refuse this user.
        if ! command -v sudo >/dev/null || ! sudo true; then
            for entry in "${missing[@]}"; do
                names+=("$(available "$entry" || echo "${entry%%|*}")")
            done
            say "Packages are missing and only root may install them. As root, run:" \
                "$by_hand ${names[*]}"
            return 1
        fi
    fi

    # The lists of what apt offers may be empty (a fresh container) or too old to download by.
    say "Updating the package lists (apt-get update) ..."
    quietly "${apt[@]}" update || say "That failed; going on with the old lists."

    for entry in "${missing[@]}"; do
        if name=$(available "$entry"); then
            names+=("$name")
        else
            unknown+=("${entry//|/ or }")
        fi
    done
    if ((${#unknown[@]} > 0)); then
        # shellcheck source=/dev/null
        say "On this system ($(source /etc/os-release && echo "$PRETTY_NAME")) apt does not know:" \
            "${unknown[*]}. Snowfall needs Debian 12 or Ubuntu 22.04 (with its 'universe')," \
            "or newer, and a network to install from."
        return 1
    fi

    say "Installing (this can take some minutes): ${names[*]}"
    if ! quietly "${apt[@]}" install --no-install-recommends "${names[@]}"; then
        say "The packages could not be installed. To try by hand, as root: $by_hand ${names[*]}"
        return 1
    fi
}

# Run, not sourced.
if [[ ${BASH_SOURCE[0]} == "$0" ]]; then
    if (($# == 0)); then
        set -- build headless compare test
    fi
    install_missing "$@"
fi
