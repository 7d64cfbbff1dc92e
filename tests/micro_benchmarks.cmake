# cmake --build build --target micro_benchmarks && build/tests/micro_benchmarks
# Not a test, and built only when asked for: its results are numbers to read.
find_package(benchmark QUIET)
if(benchmark_FOUND)
    add_executable(micro_benchmarks EXCLUDE_FROM_ALL
                   ${CMAKE_CURRENT_LIST_DIR}/micro_benchmarks.cpp)
    target_link_libraries(micro_benchmarks PRIVATE common benchmark::benchmark)
endif()
