#include "step06_accumulation/winter/light/daylight.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <iterator>

namespace {

using glm::mix;
using glm::smoothstep;
using glm::vec3;

// The sky at one height of the sun, with few clouds. Chosen by eye, and nights as an eye sees
// them that has grown used to the dark.
struct Sky {
    float sun_height;  // degrees
    vec3 zenith, horizon;
};

const Sky skies[] = {
    {-14, {0.006f, 0.011f, 0.034f}, {0.012f, 0.020f, 0.050f}},
    {-8, {0.014f, 0.026f, 0.075f}, {0.035f, 0.050f, 0.115f}},
    {-4, {0.030f, 0.058f, 0.160f}, {0.080f, 0.100f, 0.205f}},
    {0, {0.06f, 0.11f, 0.25f}, {0.20f, 0.19f, 0.26f}},
    {8, {0.10f, 0.17f, 0.34f}, {0.33f, 0.37f, 0.49f}},
    {25, {0.12f, 0.24f, 0.48f}, {0.37f, 0.49f, 0.66f}},
    {80, {0.16f, 0.30f, 0.60f}, {0.42f, 0.56f, 0.78f}},
};

Sky sky_at(float sun_height)
{
    const Sky* const last = std::end(skies) - 1;
    const Sky* above = std::begin(skies) + 1;
    while (above < last && above->sun_height < sun_height) ++above;
    const Sky &low = above[-1], &high = *above;
    const float part =
        std::clamp((sun_height - low.sun_height) / (high.sun_height - low.sun_height), 0.0f, 1.0f);
    return {sun_height, mix(low.zenith, high.zenith, part), mix(low.horizon, high.horizon, part)};
}

// The part of the sun's light, by colour, that comes through clear air: little of it, and that
// red, when it stands low. Air mass: Kasten and Young, "Revised optical air mass tables", 1989.
vec3 through_atmosphere(float height)  // degrees
{
    const vec3 optical_depth(0.09f, 0.15f, 0.29f);  // molecules and some dust: red, green, blue
    const float h = std::max(height, 0.0f);
    const float air_mass =
        1.0f / (std::sin(glm::radians(h)) + 0.50572f * std::pow(h + 6.07995f, -1.6364f));
    return glm::exp(-air_mass * optical_depth);
}

// Part of the light that a metre of the air takes away while it snows like that, 1/m. A minute of
// our snowfall stands for three hours of a real one: that makes 0.1 m/min a heavy one, in which one
// sees 3.912 / extinction = 320 m far (Koschmieder 1924).
float extinction(const snow::Weather& weather, float seconds)
{
    const float haze = weather.kind == snow::rain_kind ? 0.006f : 0.002f;  // 1/m
    const float fresh_snow = 100'000.0f;                                   // g/m3
    const snow::Emitter& cloud = weather.emitters[0];
    const float fall = cloud.centre.y / cloud.terminal_speed;  // s
    const float in_the_air = std::min(seconds / fall, 1.0f);   // of all that will be
    const float speed = 0.5f * (cloud.terminal_speed + weather.emitters[1].terminal_speed);
    const float concentration = in_the_air * weather.snowfall / 10800 * fresh_snow / speed;  // g/m3
    // Stallabrass 1985, as in Stoelinga and Warner, "Nonhydrostatic, mesobeta-scale model
    // simulations of cloud ceiling and visibility", 1999: 10.36 C^0.7776 a km.
    return haze + 0.01036f * std::pow(concentration, 0.7776f);
}

}  // namespace

Daylight::Daylight(const SolidScene& solid)
{
    for (const Vertex& vertex : solid.scene.vertices) {
        lowest_ = glm::min(lowest_, vertex.position);
        highest_ = glm::max(highest_, vertex.position);
    }
    light_.grid_corner = solid.grid.origin;
    light_.grid_size = solid.grid.cell_size * float(solid.grid.resolution);
    // All that shines, as one lamp in its middle.
    light_.lamp_radius = 0.1f;
    float corners = 0;
    for (const Submesh& submesh : solid.scene.submeshes) {
        if (submesh.material.light == vec3(0)) continue;
        for (size_t i = submesh.first; i < submesh.first + submesh.count; ++i)
            light_.lamp_position += solid.scene.corner(i).position;
        lamp_light_ += float(submesh.count) * 6.0f * submesh.material.light;
        corners += float(submesh.count);
    }
    light_.lamp_position /= std::max(corners, 1.0f);
    lamp_light_ /= std::max(corners, 1.0f);
}

std::vector<snow::Parameter> Daylight::parameters()
{
    return {
        {"shadow", "shadows", "on/off", 0, 1, "the scene keeps the sun from what lies behind it",
         &shadow},
        {"occlusion", "ambient occlusion", "on/off", 0, 1,
         "it is darker where less of the sky is seen", &occlusion},
        {"fog", "fog", "on/off", 0, 1, "the air, and more so with snow in it, hides what is far",
         &fog},
        {"lamp", "lamp", "on/off", 0, 1, "the lamp, lit from dusk on", &lamp},
        {"sun_height", "height of the sun", "degrees", -20, 80, "of the sun above the horizon",
         &sun_height},
        {"sun_direction", "direction of the sun", "degrees", 0, 360,
         "where the sun stands, from +z towards +x", &sun_direction},
    };
}

void Daylight::update(const snow::Weather& weather, unsigned tick)
{
    const float direction = glm::radians(sun_direction);
    const float seconds = float(tick) * weather.time_step;

    // A young moon follows the sun, 45 degrees behind, and takes over when that has set.
    const bool night = sun_height < 0;
    const float height = night ? sun_height + 45 : sun_height;
    const vec3 brightness =
        night ? (1 - smoothstep(-9.0f, -3.0f, sun_height)) * vec3(0.10f, 0.13f, 0.20f)
              : 3.2f * smoothstep(0.0f, 2.0f, sun_height) * through_atmosphere(height);
    const float h = glm::radians(height);
    light_.to_sun = {std::cos(h) * std::sin(direction), std::sin(h),
                     std::cos(h) * std::cos(direction)};
    light_.has_shadow = float(shadow);
    light_.has_occlusion = float(occlusion);

    // What falling snow takes from the sun: of the light that it scatters, four fifths go on nearly
    // straight and are not lost (Joseph, Wiscombe and Weinman, "The delta-Eddington
    // approximation", 1976).
    const float snowy_air = extinction(weather, seconds);
    const float layer = weather.emitters[1].centre.y;  // m, from the ground up to the clouds
    const float clear = std::exp(-0.2f * snowy_air * layer / std::max(std::sin(h), 0.1f));
    light_.sun = clear * brightness;
    light_.extinction = fog ? snowy_air : 0.0f;
    const vec3 lost =
        0.5f * (1 - clear) * std::max(std::sin(h), 0.0f) * brightness;  // the other half goes up

    const Sky sky = sky_at(sun_height);
    light_.zenith = sky.zenith + lost;
    light_.horizon = sky.horizon + lost;
    light_.sky = mix(light_.zenith, light_.horizon, 0.4f);
    // Where the sun has just set, or is about to, the sky glows.
    light_.twilight =
        std::exp(-0.04f * (sun_height + 1) * (sun_height + 1)) * vec3(0.70f, 0.28f, 0.08f);
    light_.stars = 1 - smoothstep(-12.0f, -5.0f, sun_height);

    // The ground sends back what falls on it, snow more than stone.
    const float white = smoothstep(0.0f, 0.02f, weather.snowfall / 60 * seconds);
    light_.ground =
        mix(0.2f, 0.7f, white) * (light_.sky + std::max(light_.to_sun.y, 0.0f) * light_.sun);

    const bool has_lamp = lamp && lamp_light_ != vec3(0);
    light_.lamp_is_on = has_lamp ? 1 - smoothstep(0.0f, 4.0f, sun_height) : 0.0f;
    light_.lamp = light_.lamp_is_on * lamp_light_;

    // The shadow map shows no more than the box around the scene.
    const glm::mat4 view = glm::lookAt(light_.to_sun, vec3(0), {0, 1, 0});
    vec3 low(view * glm::vec4(lowest_, 1)), high = low;
    for (int corner = 1; corner < 8; ++corner) {
        const vec3 place((corner & 1) != 0 ? highest_.x : lowest_.x,
                         (corner & 2) != 0 ? highest_.y : lowest_.y,
                         (corner & 4) != 0 ? highest_.z : lowest_.z);
        const vec3 seen(view * glm::vec4(place, 1));
        low = glm::min(low, seen);
        high = glm::max(high, seen);
    }
    light_.to_shadow_map = glm::ortho(low.x, high.x, low.y, high.y, -high.z, -low.z) * view;

    block_.update(LIGHT_BLOCK, light_);
}

std::string Daylight::parts() const
{
    std::string parts;
    if (light_.has_shadow != 0) parts += "#define SHADOW\n";
    if (light_.has_occlusion != 0) parts += "#define OCCLUSION\n";
    if (light_.lamp_is_on != 0) parts += "#define LAMP\n";
    return parts;
}
