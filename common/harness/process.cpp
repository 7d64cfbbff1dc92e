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

#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>

#include "common/snow.hpp"

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

double free_memory()
{
    constexpr double unknown = std::numeric_limits<double>::infinity();
#ifdef _WIN32
    MEMORYSTATUSEX status{};
    status.dwLength = sizeof status;
    return GlobalMemoryStatusEx(&status) ? double(status.ullAvailPageFile) / (1 << 20) : unknown;
#else
    std::ifstream file("/proc/meminfo");
    double kibibytes = 0;
    for (std::string name; file >> name;) {
        if (name == "MemAvailable:" && file >> kibibytes) return kibibytes / 1024;
    }
    return unknown;
#endif
}

double size_of_flakes(unsigned flakes)
{
    return double(flakes) * sizeof(snow::Particle) / (1 << 20);
}

void check_memory_for_flakes(unsigned flakes, bool in_software, double available)
{
    const int copies = in_software ? 3 : 1;  // the first, from which two buffers are filled
    const double needed = copies * size_of_flakes(flakes);
    if (needed <= available) return;
    char line[160];
    std::snprintf(line, sizeof line,
                  "not enough memory: %u flakes need %.0f MiB, %.0f MiB are free "
                  "(try fewer --particles)",
                  flakes, needed, available);
    throw std::runtime_error(line);
}
