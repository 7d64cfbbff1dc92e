// The pool in groups, of which each is drawn with points of one size: OpenGL 1 cannot change the
// size within a group.
#pragma once

#include <vector>

#include "common/lesson.hpp"

struct Group {
    unsigned begin, end;  // indices of its first flake, and of the first behind it
    float point_size;     // pixels
};

// Two groups, one for each emitter: the first half of the pool is emitter 0's, of small flakes, the
// second half emitter 1's. (--groups and --point-size ask for other groups, to be compared.)
inline std::vector<Group> make_groups(const Options& options)
{
    const uint64_t particles = options.weather.particles;
    std::vector<Group> groups;
    for (unsigned i = 0; i < options.groups; ++i) {
        const auto begin = unsigned(particles * i / options.groups);
        const auto end = unsigned(particles * (i + 1) / options.groups);
        const bool is_small = snow::of_first_emitter(begin, options.weather);
        groups.push_back({begin, end, options.point_size * (is_small ? 1.0f : 2.0f)});
    }
    return groups;
}
