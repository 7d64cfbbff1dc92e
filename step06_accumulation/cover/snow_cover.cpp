#include "step06_accumulation/cover/snow_cover.hpp"

#include <cstdint>
#include <cstring>
#include <iostream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include "common/bindings.glsl"
#include "common/harness/output.hpp"

namespace {

struct Sums {  // as snow_cover.glsl has them: little-endian, the low word first
    GLuint64 deposited, melted;
};

// s from a flake's birth until it comes to lie: it falls, and may bounce. Found by letting one
// fall, without what makes flakes differ or takes them out of the air.
double time_in_air(snow::Weather weather, snow::uint emitter)
{
    weather.particles = 2;
    weather.variation = weather.turbulence = weather.swirl = 0;
    weather.wind = {};
    weather.lifetime = std::numeric_limits<float>::max();
    snow::Particle flake = snow::born(emitter, 0, weather);
    flake.position.y = weather.emitters[emitter].centre.y;
    snow::uint tick = 0;
    const snow::uint most = 100'000;  // where hardly anything pulls it down, it never lands
    for (; tick < most && flake.rest == 0 && !snow::gone(flake, emitter, weather); ++tick) {
        flake = snow::settle(snow::move(flake, weather), weather);
        flake = snow::accelerate(flake, weather.wind, emitter, tick, weather);
    }
    return double(tick) * weather.time_step;
}

}  // namespace

SnowCover::SnowCover(int resolution, int layers)
    : resolution_(size_t(resolution)), layers_(size_t(layers)), mass_(make_buffer()),
      sums_(make_buffer())
{
    const auto bytes = GLsizeiptr(resolution_ * layers_ * resolution_ * sizeof(GLuint));
    GLint64 largest = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest);
    if (bytes > largest) {
        throw std::runtime_error("--voxels " + std::to_string(resolution_) +
                                 ": the snow cover needs " + std::to_string(bytes) +
                                 " bytes, this card's buffers end at " + std::to_string(largest));
    }
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, mass_);
    glBufferData(GL_SHADER_STORAGE_BUFFER, bytes, nullptr, GL_DYNAMIC_COPY);
    check_memory("the cells of snow", double(bytes));
    glClearBufferData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);

    const Sums zero{};
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, sums_);
    glBufferData(GL_SHADER_STORAGE_BUFFER, sizeof zero, &zero, GL_DYNAMIC_COPY);
}

void SnowCover::bind() const
{
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, COVER_BUFFER, mass_);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SUMS_BUFFER, sums_);
}

float SnowCover::flake_mass(const snow::Weather& weather, const VoxelGrid& grid)
{
    // To find the time in the air flakes are let fall, which takes a while: not anew in every
    // frame, nor whenever the clouds have gone on with the camera.
    snow::Weather here = weather;
    for (snow::Emitter& cloud : here.emitters) cloud.centre.x = cloud.centre.z = 0;
    if (weather_ && std::memcmp(&*weather_, &here, sizeof here) == 0) return flake_mass_;
    weather_ = here;
    double volume = 0;  // m3 a second, of the cubes around the flakes that come to lie
    for (const snow::uint emitter : {0u, 1u}) {
        const double d = weather.emitters[emitter].diameter, v = weather.variation;
        const double mean = d * d * d * (1 + v * v);  // of the cubes of d (1 - v) to d (1 + v)
        const double air = time_in_air(weather, emitter);
        // Those that do not live that long never lie; those that do lie once in every cycle.
        volume += 0.5 * weather.particles * mean * snow::part_alive(float(air), weather) /
                  (air + weather.melt_time);
    }
    const snow::Emitter& cloud = weather.emitters[0];
    const double area = 4.0 * cloud.half_size.x * cloud.half_size.z;  // m2
    const double snow = weather.snowfall / 60.0 * area;               // m3 a second
    const double cell = double(grid.cell_size) * grid.cell_size * grid.cell_size;
    flake_mass_ = volume > 0 ? float(65536 * snow / cell / volume) : 0.0f;
    return flake_mass_;
}

std::vector<GLuint> SnowCover::read() const
{
    std::vector<GLuint> mass(resolution_ * layers_ * resolution_);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, mass_);
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, GLsizeiptr(mass.size() * sizeof(GLuint)),
                       mass.data());
    check_read_back("the snow cover");
    return mass;
}

void SnowCover::report(const VoxelGrid& grid, const std::filesystem::path& path) const
{
    const std::vector<GLuint> mass = read();
    uint64_t lying = 0;
    for (const GLuint cell : mass) lying += cell;
    Sums sums{};
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, sums_);
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof sums, &sums);
    check_read_back("the snow cover's sums");
    std::cout << "cover: lying " << lying << " + melted " << sums.melted << " = deposited "
              << sums.deposited << std::endl;

    if (path.empty()) return;
    std::ostringstream csv;
    csv << "# origin " << grid.origin.x << " " << grid.origin.y << " " << grid.origin.z << " cell "
        << grid.cell_size << " full 65536\ni,j,k,mass\n";
    const size_t n = resolution_;
    for (size_t cell = 0; cell < mass.size(); ++cell) {
        if (mass[cell] == 0) continue;
        csv << cell % n << "," << cell / n % layers_ << "," << cell / (n * layers_) << ","
            << mass[cell] << "\n";
    }
    write_file(path, csv.str());
}
