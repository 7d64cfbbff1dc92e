#include "common/harness/dump.hpp"

#include <cstdio>
#include <string>

#include "common/harness/files.hpp"

void dump_flakes(const std::filesystem::path& path, std::span<const snow::Particle> flakes)
{
    if (path.empty()) return;
    std::string csv = "index,x,y,z,age,vx,vy,vz,rest\n";
    char line[256];
    for (size_t i = 0; i < flakes.size(); ++i) {
        const snow::Particle& p = flakes[i];
        std::snprintf(line, sizeof line, "%zu,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", i,
                      p.position.x, p.position.y, p.position.z, p.age, p.velocity.x, p.velocity.y,
                      p.velocity.z, p.rest);
        csv += line;
    }
    write_file(path, csv);
}
