#include <iostream>
#include <new>
#include <stdexcept>

#include "common/harness/harness.hpp"
#include "common/harness/streams.hpp"
#include "common/window.hpp"

int run_lesson(int argc, char** argv, const Lesson& lesson)
try {
    open_standard_streams();
    Window window(parse_command_line(argc, argv, lesson));
    do window.harness_->command.chosen().run(window);
    while (window.restarted());
    return window.harness_->failed() || !flush_standard_output() ? 1 : 0;
} catch (const std::bad_alloc&) {
    std::cerr << "error: not enough memory (try fewer --particles or --voxels)" << std::endl;
    return 1;
} catch (const std::exception& failure) {
    std::cerr << "error: " << failure.what() << std::endl;
    return 1;
}
