# shellcheck shell=bash
#
# Builds Snowfall: for common/run.sh and tests/run.sh, which source this file and install.sh.

# Succeeds if a file or folder can be written or, where there is none, be made.
writable()
{
    local path=$1
    [[ -e $path ]] || path=$(dirname "$path")
    [[ -w $path ]]
}

# check_build_folder FOLDER: said now, not after minutes of installing.
check_build_folder()
{
    if ! writable "$1"; then
        say "The folder $1 cannot be written. Please copy $(dirname "$1") to a place of your own."
        return 1
    fi
}

# with_progress LOG COMMAND...: shows how far a build is, where somebody looks on, and all of its
# output if it fails.
with_progress()
{
    local log=$1 line status=0
    shift
    "$@" 2>&1 | tee "$log" | while IFS= read -r line; do
        # Make begins its lines with "[ 42%]".
        if [[ -t 2 && $line == '['*'%]'* ]]; then printf '\r%s' "${line%%]*}]" >&2; fi
    done || status=$?
    if [[ -t 2 ]]; then printf '\r       \r' >&2; fi
    if ((status != 0)); then cat "$log" >&2; fi
    return "$status"
}

# build_in FOLDER CMAKE_OPTION...: returns 1, after a line that says what to do, if it fails.
build_in()
{
    local folder=$1 failed=
    shift
    say "Building in $folder (this can take some minutes) ..."
    if ! quietly cmake -S "$(dirname "$folder")" -B "$folder" -DCMAKE_BUILD_TYPE=Release "$@"; then
        failed="CMake failed, as it says above. If $(dirname "$folder") was moved or copied, remove its folder '$(basename "$folder")'."
    elif ! with_progress "$folder/build.log" cmake --build "$folder" --parallel "$(nproc)"; then
        failed="The build in $folder failed, as the compiler says above."
    fi
    [[ -n $failed ]] || return 0
    # KiB that are left: in the last line, fourth from the left.
    if (($(df -Pk "$(dirname "$folder")" | tail -n 1 | awk '{ print $4 }') < 10240)); then
        failed="The disk of $folder is full."
    fi
    say "$failed"
    return 1
}
