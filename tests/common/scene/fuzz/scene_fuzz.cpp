// Looks for scenes that break the code that reads them, for as long as it is let, with Clang:
//
//     cmake -B build-fuzz -DCMAKE_CXX_COMPILER=clang++ -DSNOWFALL_SANITIZE=ON -DSNOWFALL_FUZZ=ON
//     cmake --build build-fuzz --target scene_fuzz
//     build-fuzz/tests/scene_fuzz -max_total_time=300 -dict=tests/common/scene/fuzz/scene.dict
//
// What it finds it leaves in a file, and runs again if it is given that as an argument. (It finds
// what ../scene_fuzz_test.cpp, which runs with all the other tests, has no time for.)
#include "tests/common/scene/fuzz/scene_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, size_t size)
{
    static const SceneInput input;
    input.load({reinterpret_cast<const char*>(bytes), size});
    return 0;
}
