#!/usr/bin/env bash
#
# Does Snowfall build elsewhere than where it was written, and otherwise? Without a warning.
#
#     tests/portability/build.sh debug | lto | clang | no-tests | vcpkg | mingw
#
# debug: as a student with a debugger builds it; then each program draws a picture.
# lto: optimised as a whole, which finds types of one name that differ from file to file; the same.
# clang: with Clang.
# no-tests: where what the tests need is missing.
# vcpkg: with stb and ImGui as vcpkg lays them out, beside Debian's own packages.
# mingw: every source for Windows, read and not linked, but for what knows of files: that is tried with
#     names beyond ASCII, where there is Wine.
#
# Everything comes from Debian's packages, nothing from the network. What it builds lies in $TMPDIR,
# or /tmp, and is removed. Exit status 77, after one line that says why, where it cannot be tried.

set -euo pipefail

root=$(readlink -f -- "$(dirname "$0")/../..")

say() { printf '%s\n' "$*" >&2; }
skip() { say "Skipped: $*"; exit 77; }
need() { command -v "$1" >/dev/null || skip "$1 is missing (Debian's package $2)."; }

folder=$(mktemp -d -- "${TMPDIR:-/tmp}/build.XXXXXX")
trap 'rm -rf -- "$folder"' EXIT

configure()
{
    cmake -S "$root" -B "$folder/build" -DCMAKE_BUILD_TYPE=Debug -DSNOWFALL_NATIVE=OFF \
        -DCMAKE_CXX_FLAGS=-Werror "$@"
}

build() { cmake --build "$folder/build" --parallel "$(nproc)" "$@"; }

# Each program once, on the display that is there or on one in memory.
run_all()
{
    local display=() step
    [[ -n ${DISPLAY:-} ]] || display=(xvfb-run -a -s "-screen 0 1280x1024x24 +extension GLX -noreset")
    for step in "$root"/step0*/; do
        step=$(basename "$step")
        "${display[@]}" "$folder/build/$step" --frames 3 --screenshot "$folder/$step.png"
        [[ -s $folder/$step.png ]]
    done
}

with_debug()
{
    configure -DSNOWFALL_TESTS=OFF
    build
    run_all
}

with_lto()
{
    configure -DSNOWFALL_TESTS=OFF -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_INTERPROCEDURAL_OPTIMIZATION=ON -DCMAKE_CXX_FLAGS="-Werror -Wodr -Werror=odr"
    build
    run_all
}

with_clang()
{
    need clang++ clang
    configure -DCMAKE_CXX_COMPILER=clang++ -DSNOWFALL_TESTS=OFF
    build
}

with_no_tests()
{
    configure -DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON | tee "$folder/log"
    grep "No tests are built" "$folder/log"
    build --target help >"$folder/targets"
    grep step06_accumulation "$folder/targets"
    if grep unit_tests "$folder/targets"; then return 1; fi
}

# Headers lie flat there, and ImGui is a package of CMake's. Debian's own are there as well, of which
# nothing may be mixed in.
with_vcpkg()
{
    local prefix=$folder/installed headers=/usr/include/imgui library
    library=$(find /usr/lib -name libimgui.a | head -n 1)
    [[ -n $library ]] || skip "ImGui is missing (Debian's package libimgui-dev)."
    mkdir -p "$prefix"/{include,lib,share/imgui}
    cp "$headers"/im*.h "$headers"/backends/imgui_impl_{glut,opengl2}.h \
        /usr/include/stb/stb_image{,_write}.h "$prefix/include"
    cp "$library" "$prefix/lib"
    # vcpkg's needs no other library; this one, Debian's, takes stb from one.
    cat >"$prefix/share/imgui/imgui-config.cmake" <<'END'
add_library(imgui::imgui STATIC IMPORTED)
set_target_properties(imgui::imgui PROPERTIES
    IMPORTED_LOCATION ${CMAKE_CURRENT_LIST_DIR}/../../lib/libimgui.a
    INTERFACE_INCLUDE_DIRECTORIES ${CMAKE_CURRENT_LIST_DIR}/../../include
    INTERFACE_LINK_LIBRARIES stb)
END
    configure -DCMAKE_PREFIX_PATH="$prefix" -DSNOWFALL_TESTS=OFF \
        -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
    if grep -oE "/usr/include/(imgui|stb)[^ \"]*" "$folder/build/compile_commands.json"; then
        say "Headers of Debian's own ImGui or stb are mixed with vcpkg's."
        return 1
    fi
    build --target step03_shader_points
}

with_mingw()
{
    local compiler=x86_64-w64-mingw32-g++ headers=$folder/include status=0
    need $compiler g++-mingw-w64-x86-64
    mkdir -p "$headers/GL"
    ln -s /usr/include/GL/{glew,wglew,freeglut,freeglut_std,freeglut_ext,glut}.h "$headers/GL"
    ln -s /usr/include/{glm,CLI} /usr/include/imgui/im*.h /usr/include/imgui/backends/imgui_impl_*.h \
        /usr/include/stb/stb_image{,_write}.h /usr/include/tiny_obj_loader.h "$headers"
    find "$root"/common "$root"/step* -name '*.cpp' -print0 |
        xargs -0 -P "$(nproc)" -n 1 $compiler -fsyntax-only -std=c++20 -Wall -Wextra -Wpedantic \
            -Wshadow -Werror -DSNOWFALL_SOURCE_DIR='""' -I "$root" -isystem "$headers" || status=$?
    ((status == 0)) || return $status
    command -v wine >/dev/null || { say "No Wine: nothing is run."; return; }
    "${compiler%g++}windres" "$root/common/harness/windows/utf8.rc" "$folder/utf8.o"
    $compiler -std=c++20 -O1 -static -DSNOWFALL_SOURCE_DIR='""' -I "$root" -isystem "$headers" \
        -DSTB_HAS_NO_LIBRARY "$root"/tests/portability/names.cpp \
        "$root"/common/{files,gl_object,weather}.cpp "$root"/common/harness/{options,output}.cpp \
        "$root"/common/scene/*.cpp "$folder/utf8.o" -lopengl32 -o "$folder/names.exe"
    cd "$folder"
    printf 'v 0 0 0\nv 1 0 0\nv 1 0 1\nmtllib Straße.mtl\nusemtl a\nvt 0 0\nf 1/1 2/1 3/1\n' >"Häuser.obj"
    printf 'newmtl a\nmap_Kd 雪.png\n' >"Straße.mtl"
    echo "a picture" >"雪.png"
    # In the C locale Wine itself would leave nothing of such names.
    export LC_ALL=C.UTF-8 WINEPREFIX=$folder/wine WINEDEBUG=-all
    wine ./names.exe --scene "Häuser.obj" --dump "Höhe.csv" || status=$?
    wineserver -k || true  # or it would still write to a folder that is gone
    ((status == 0)) || return $status
    cmp "雪.png" "Höhe.csv"
}

case ${1:-} in
    debug | lto | clang | no-tests | vcpkg | mingw) "with_${1//-/_}" ;;
    *) sed -n '/^#     /s/^# */Usage: /p' "$0" >&2; exit 2 ;;
esac
