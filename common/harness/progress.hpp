// Tells a user who waits how far the program is.
#pragma once

#include <chrono>
#include <cstdio>
#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

// Says how far something is, every half second, if it takes longer than that: on a terminal, and
// leaves nothing there.
class Progress {
public:
    explicit Progress(const char* what) : what_(what) {}
    ~Progress()
    {
        if (reported_) std::fputs(clear_line, stderr);
    }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    bool due() const { return Clock::now() - last_report_ >= std::chrono::milliseconds(500); }

    void report(double done)  // 0 to 1
    {
        last_report_ = Clock::now();
#ifdef _WIN32
        reported_ = _isatty(2) != 0;
#else
        reported_ = isatty(2) != 0;
#endif
        if (reported_) std::fprintf(stderr, "%s%s %.0f %%", clear_line, what_, 100 * done);
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr const char* clear_line = "\r\033[K";
    const char* what_;
    Clock::time_point last_report_ = Clock::now();
    bool reported_ = false;
};
