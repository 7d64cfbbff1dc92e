// Tells a user who waits how far the program is.
#pragma once

#include <chrono>
#include <exception>
#include <iostream>

// Says on stderr how far something is, every half second, if it takes longer than that.
class Progress {
public:
    explicit Progress(const char* what) : what_(what) {}
    ~Progress()
    {
        if (!reported_) return;
        if (std::uncaught_exceptions() == 0) std::cerr << "\r" << what_ << " 100 %";
        std::cerr << "\n";
    }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    bool due() const { return Clock::now() - last_report_ >= std::chrono::milliseconds(500); }

    void report(double done)  // 0 to 1
    {
        last_report_ = Clock::now();
        reported_ = true;
        std::cerr << "\r" << what_ << " " << int(100 * done) << " %" << std::flush;
    }

private:
    using Clock = std::chrono::steady_clock;
    const char* what_;
    Clock::time_point last_report_ = Clock::now();
    bool reported_ = false;
};
