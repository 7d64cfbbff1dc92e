#include "step06_accumulation/winter/frame_block.hpp"

#include <algorithm>
#include <cmath>
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
    const float t =
        std::clamp((sun_height - low.sun_height) / (high.sun_height - low.sun_height), 0.0f, 1.0f);
    return {sun_height, mix(low.zenith, high.zenith, t), mix(low.horizon, high.horizon, t)};
}

// The fraction of the sun's light, by colour, that comes through clear air: little of it, and that
// red, when it stands low. Air mass: Kasten and Young, "Revised optical air mass tables", 1989.
vec3 through_atmosphere(float height)  // degrees
{
    const vec3 optical_depth(0.09f, 0.15f, 0.29f);  // molecules and some dust: red, green, blue
    const float h = std::max(height, 0.0f);
    const float air_mass =
        1.0f / (std::sin(glm::radians(h)) + 0.50572f * std::pow(h + 6.07995f, -1.6364f));
    return glm::exp(-air_mass * optical_depth);
}

// The fraction of the light that a metre of the air takes away while it snows like that, 1/m. A
// minute of our snowfall stands for three hours of a real one: that makes 0.1 m/min a heavy one, in
// which one sees 3.912 / extinction = 320 m far (Koschmieder 1924).
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

// World space to the clip space of the shadow map, which shows no more than the box around the
// scene.
glm::mat4 shadow_projection(vec3 to_sun, vec3 lowest, vec3 highest)
{
    const glm::mat4 view = glm::lookAt(to_sun, vec3(0), {0, 1, 0});
    const vec3 middle(view * glm::vec4(0.5f * (lowest + highest), 1));
    vec3 reach(0);  // from there to the sides of the box
    for (int axis = 0; axis < 3; ++axis)
        reach += 0.5f * (highest[axis] - lowest[axis]) * glm::abs(vec3(view[axis]));
    const vec3 low = middle - reach, high = middle + reach;
    return glm::ortho(low.x, high.x, low.y, high.y, -high.z, -low.z) * view;
}

}  // namespace

FrameBlock::FrameBlock(const SolidScene& solid)
{
    for (const Vertex& vertex : solid.scene.vertices) {
        lowest_ = glm::min(lowest_, vertex.position);
        highest_ = glm::max(highest_, vertex.position);
    }
    frame_.fine_enough = 3 * solid.grid.cell_size;
    // All that shines, as one lamp in its middle.
    frame_.lamp_radius = 0.1f;
    float corners = 0;
    for (const Submesh& submesh : solid.scene.submeshes) {
        if (submesh.material.light == vec3(0)) continue;
        for (size_t i = submesh.first; i < submesh.first + submesh.count; ++i)
            frame_.lamp_position += solid.scene.corner(i).position;
        lamp_light_ += float(submesh.count) * 6.0f * submesh.material.light;
        corners += float(submesh.count);
    }
    frame_.lamp_position /= std::max(corners, 1.0f);
    lamp_light_ /= std::max(corners, 1.0f);
}

const snow::Frame& FrameBlock::update(const Window& window, const Settings& settings, unsigned tick)
{
    const snow::Weather& weather = window.options().weather;
    frame_.view_before = frame_.window_size.x == 0 ? window.view() : frame_.view;
    frame_.view = window.view();
    frame_.projection = window.projection();
    frame_.eye = window.eye();
    // Where the screen is faster than the time steps, some frames show the same flakes once more:
    // as before, or streaks and dots would alternate.
    if (window.ticks() > 0) {
        frame_.shutter =
            float(window.ticks()) * weather.time_step / float(window.options().timelapse);
    }
    frame_.window_size = window.size();
    // The snow on open ground. The first flakes, fewer than there will be, fall and lie for a while
    // before they are part of the cover; and depth.comp lets that appear in some ten rounds.
    const snow::Emitter& cloud = weather.emitters[0];
    const float late = 1.25f * cloud.centre.y / cloud.terminal_speed + weather.melt_time +
                       10 * Columns::steps_per_round * weather.time_step;  // s
    const float now = float(tick) * weather.time_step,
                before = float(tick_before_) * weather.time_step;
    tick_before_ = tick;
    const float snows = std::max(now, late) - std::max(before, late);  // s
    const float thaw =
        settings.cover.melting ? 0.01f * std::max(weather.temperature, 0.0f) : 0.0f;  // m/min
    frame_.field_depth = std::max(
        frame_.field_depth + (weather.snowfall * snows - thaw * (now - before)) / 60.0f, 0.0f);
    light(weather, settings, now);
    frame_.exposure = settings.exposure;
    frame_.bloom = settings.bloom;
    frame_.colours = int(std::lround(settings.colours));
    block_.update(FRAME_BLOCK, frame_);
    return frame_;
}

// seconds: since the first flake.
void FrameBlock::light(const snow::Weather& weather, const Settings& settings, float seconds)
{
    // A young moon follows the sun, 45 degrees behind, and takes over when that has set.
    const bool night = settings.sun_height < 0, rains = weather.kind == snow::rain_kind;
    const float overcast = rains ? 1.0f : settings.overcast;
    // Stones are wet after some seconds of rain.
    frame_.wetness = rains ? smoothstep(0.0f, 20.0f, seconds) : 0.0f;
    const float height = night ? settings.sun_height + 45 : settings.sun_height;
    const vec3 brightness =
        night ? (1 - smoothstep(-9.0f, -3.0f, settings.sun_height)) * vec3(0.10f, 0.13f, 0.20f)
              : 3.2f * smoothstep(0.0f, 2.0f, height) * through_atmosphere(height);
    const float direction = glm::radians(settings.sun_direction), h = glm::radians(height);
    frame_.to_sun = {std::cos(h) * std::sin(direction), std::sin(h),
                     std::cos(h) * std::cos(direction)};
    frame_.to_shadow_map = shadow_projection(frame_.to_sun, lowest_, highest_);

    // What falling snow takes from the sun: of the light that it scatters, four fifths go on nearly
    // straight and are not lost (Joseph, Wiscombe and Weinman, "The delta-Eddington
    // approximation", 1976).
    const float snowy_air = extinction(weather, seconds);
    const float layer = weather.emitters[1].centre.y;  // m, from the ground up to the clouds
    const float clear = std::exp(-0.2f * snowy_air * layer / std::max(std::sin(h), 0.1f));
    frame_.sun = (1 - overcast) * clear * brightness;
    frame_.extinction = settings.fog ? snowy_air : 0.0f;
    const vec3 lost =
        0.5f * (1 - clear) * std::max(std::sin(h), 0.0f) * brightness;  // the other half goes up

    // Clouds are grey, and brighter overhead than at the horizon.
    Sky sky = sky_at(settings.sun_height);
    const vec3 luminance(0.21f, 0.72f, 0.07f);  // of red, green and blue
    const float grey = dot(0.5f * (sky.zenith + sky.horizon), luminance) +
                       0.45f * std::max(std::sin(h), 0.0f) * dot(brightness, luminance);
    sky.zenith = mix(sky.zenith, vec3(grey), overcast);
    sky.horizon = mix(sky.horizon, vec3(0.5f * grey), overcast);
    frame_.zenith = sky.zenith + lost;
    frame_.horizon = sky.horizon + lost;
    frame_.sky = mix(frame_.zenith, frame_.horizon, 0.4f);
    // Where the sun has just set, or is about to, the sky glows.
    const float from_horizon = settings.sun_height + 1;
    frame_.twilight =
        (1 - overcast) * std::exp(-0.04f * from_horizon * from_horizon) * vec3(0.70f, 0.28f, 0.08f);

    // The ground sends back what falls on it, snow more than stone.
    const float white = smoothstep(0.0f, 0.02f, frame_.field_depth);
    frame_.ground =
        mix(0.2f, 0.7f, white) * (frame_.sky + std::max(frame_.to_sun.y, 0.0f) * frame_.sun);

    const bool has_lamp = settings.lamp && lamp_light_ != vec3(0);
    frame_.lamp_is_on =
        has_lamp ? 1 - smoothstep(0.0f, Settings::lamp_off_height, settings.sun_height) : 0.0f;
    frame_.lamp = frame_.lamp_is_on * lamp_light_;
}
