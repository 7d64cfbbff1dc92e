// What the system knows of this process.
#pragma once

#include <filesystem>

// Where its executable lies; the current folder where the system does not tell.
std::filesystem::path executable_folder();

// Memory that it has in use, MiB; 0 where the system does not tell.
double process_memory();
