#include "common/harness/process.hpp"

#ifdef _WIN32
#ifndef NOMINMAX
#define NOMINMAX
#endif
#define WIN32_LEAN_AND_MEAN
#define PSAPI_VERSION 2  // GetProcessMemoryInfo is in a library that every program has
#include <windows.h>

#include <psapi.h>
#else
#include <unistd.h>

#include <fstream>
#endif

namespace fs = std::filesystem;

fs::path executable_folder()
{
#ifdef _WIN32
    wchar_t executable[32768];  // the longest path there can be
    const DWORD length = GetModuleFileNameW(nullptr, executable, DWORD(std::size(executable)));
    return length > 0 ? fs::path(executable, executable + length).parent_path()
                      : fs::current_path();
#else
    std::error_code error;
    const fs::path executable = fs::read_symlink("/proc/self/exe", error);
    return error ? fs::current_path() : executable.parent_path();
#endif
}

double process_memory()
{
#ifdef _WIN32
    PROCESS_MEMORY_COUNTERS counters{};
    GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters);
    return double(counters.WorkingSetSize) / (1 << 20);
#else
    long pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return double(resident) * double(sysconf(_SC_PAGESIZE)) / (1 << 20);
#endif
}
