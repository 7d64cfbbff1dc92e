# build/tests/micro_benchmarks
# Not a test: its results are numbers to read.
find_package(benchmark QUIET)
if(benchmark_FOUND)
    add_executable(micro_benchmarks
                   ${CMAKE_CURRENT_LIST_DIR}/micro_benchmarks.cpp)
    target_link_libraries(micro_benchmarks PRIVATE step05_collision_modules benchmark::benchmark)
endif()
