#!/usr/bin/env bash
#
# Does the README's "Run it" hold on a machine that has nothing? Makes a Debian of apt, sudo and no
# more, and runs common/run.sh in it, without a display and from a folder whose name has a space and
# an umlaut. It has to succeed and to leave its picture.
#
#     tests/portability/bare.sh [--as root|student] [--tests|--build-tests] [SUITE]
#
# SUITE: bookworm (the default), trixie, forky.
# --as: only as root, or only as a user with sudo; otherwise as both, each on a Debian of its own.
# --tests: runs tests/run.sh afterwards. --build-tests: builds them, no more.
#
# Packages come from where this machine has its own from. The Debian lies in $TMPDIR, or /tmp, and
# is removed. Exit status 77, after one line that says why, where none can be made.

set -euo pipefail

say() { printf '%s\n' "$*" >&2; }
skip() { say "Skipped: $*"; exit 77; }

root=$(readlink -f -- "$(dirname "$0")/../..")
folder="/home/student/Schöne Flocken"

# inside ROOTFS: called back by mmdebstrap when the Debian stands.
inside()
{
    local rootfs=$1 began=$SECONDS
    touch "$signs/stands"
    echo "127.0.0.1 localhost $(uname -n)" >"$rootfs/etc/hosts"  # or sudo complains
    chroot "$rootfs" useradd --create-home --shell /bin/bash student
    echo "student ALL=(ALL) NOPASSWD: ALL" >"$rootfs/etc/sudoers.d/student"
    mkdir "$rootfs$folder"
    tar -C "$root" --exclude=./.git --exclude='./build*' --exclude='./snowfall_step*' -c . |
        tar -C "$rootfs$folder" -x
    chroot "$rootfs" chown -R "$who:" "$folder"

    # A login that brings nothing along from here, a DISPLAY least of all.
    log_in_and()
    {
        # shellcheck disable=SC2016  # expanded in there
        env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin chroot "$rootfs" \
            su --login -c 'cd "$1" && shift && "$@"' -- "$who" sh "$folder" "$@" </dev/null
    }

    say "A bare $suite stands. As $who: common/run.sh 1"
    log_in_and common/run.sh 1
    if [[ $(head -c 4 "$rootfs$folder/snowfall_step01.png" | tail -c 3) != PNG ]]; then
        say "common/run.sh says that all went well, but there is no picture."
        return 1
    fi
    say "Done in $((SECONDS - began)) s."
    if [[ -n $tests ]]; then
        say "As $who: $tests"
        # shellcheck disable=SC2086  # a command and its option
        log_in_and $tests
        say "Done in $((SECONDS - began)) s."
    fi
}

if [[ ${1:-} == --inside ]]; then
    inside "$2"
    exit
fi

users=(root student)
tests=
while [[ ${1:-} == -* ]]; do
    case $1 in
        --as) users=("$2"); shift ;;
        --tests) tests=tests/run.sh ;;
        --build-tests) tests="tests/run.sh -N" ;;  # ctest then shows them only
        *) sed -n '/^#     /s/^# */Usage: /p' "$0" >&2; exit 2 ;;
    esac
    shift
done
suite=${1:-bookworm}

temporary=${TMPDIR:-/tmp}
command -v mmdebstrap >/dev/null || skip "mmdebstrap is missing (Debian's package of this name)."
if ((EUID == 0)); then
    unshare --mount true 2>/dev/null || skip "mmdebstrap has to mount, which root may not here."
else
    mmdebstrap --unshare-helper test -w "$temporary" 2>/dev/null ||
        skip "mmdebstrap needs root, or user namespaces that may write to $temporary."
fi

# How this machine downloads packages, and from where: its sources, with the suite's name in place
# of its own. Where there are none, as on Ubuntu, mmdebstrap takes Debian's.
# shellcheck disable=SC2016  # $(...) is apt's
mapfile -t sources < <(apt-get indextargets --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' \
    'Created-By: Packages' 'Origin: Debian')
# shellcheck source=/dev/null
here=$(source /etc/os-release && echo "${VERSION_CODENAME:-}")
mapfile -t options < <(apt-config dump --no-empty --format '%F "%v"%n' Acquire |
    grep -v IndexTargets)

# Where the Debian tells that it stands. Its root is another user here, if this one is not root.
signs=$(mktemp -d -- "$temporary/bare.XXXXXX")
trap 'rm -rf -- "$signs"' EXIT
chmod 777 "$signs"
export suite tests who signs
hook="$(printf '%q' "$root/tests/portability/bare.sh") --inside \"\$1\""
for who in "${users[@]}"; do
    rm -f -- "$signs/stands"
    # force-unsafe-io: what is removed afterwards need not be safe on the disk.
    if ! mmdebstrap --quiet --variant=apt --include=sudo,passwd --dpkgopt=force-unsafe-io \
        "${options[@]/#/--aptopt=}" --customize-hook="$hook" --format=null \
        "$suite" - "${sources[@]/ $here/ $suite}"; then
        [[ -e $signs/stands ]] || skip "mmdebstrap could make no $suite, as it says above."
        say "On a bare $suite, as $who, it fails: see above."
        exit 1
    fi
done
