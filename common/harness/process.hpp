// What the system knows of this process.
#pragma once

#include <filesystem>

// Where its executable lies; the current folder where the system does not tell.
std::filesystem::path executable_folder();

// Memory that it has in use, MiB; 0 where the system does not tell.
double process_memory();

// Memory that it could have besides, MiB; infinite where the system does not tell.
double free_memory();

// To be called before the flakes of a run are made, as Linux grants memory that it has not got, and
// ends without a word who comes to use it. available: what free_memory() says. in_software:
// OpenGL's buffers lie in main memory, too. Throws std::runtime_error if there is not enough.
void check_memory_for_flakes(unsigned flakes, bool in_software, double available);

// What so many flakes take, MiB.
double size_of_flakes(unsigned flakes);
