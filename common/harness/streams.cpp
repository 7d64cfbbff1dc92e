#include "common/harness/streams.hpp"

#include <cstdio>
#include <iostream>
#ifndef _WIN32
#include <fcntl.h>
#include <unistd.h>
#endif

void open_standard_streams()
{
#ifndef _WIN32
    for (const int descriptor : {0, 1, 2}) {
        // The lowest number that is free is what open returns.
        if (fcntl(descriptor, F_GETFD) < 0 && open("/dev/null", O_RDWR) < 0) return;
    }
#endif
}

bool flush_standard_output()
{
    std::cout.flush();
    if (std::cout && std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return true;
    std::cerr << "error: cannot write to the standard output (is the disk full?)" << std::endl;
    return false;
}
