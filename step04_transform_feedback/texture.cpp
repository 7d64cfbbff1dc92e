// The variant "texture": same as main.cpp, but the flakes are pixels. Their state lies in textures
// of floating-point numbers, and a fragment shader moves them while one triangle is drawn over all
// of it, as GPUs did it before transform feedback (Introduction to Computer Graphics project sheet,
// part 3: "the integration can be done in the fragment shader").

#include <GL/glew.h>

#include "common/program.hpp"
#include "common/uniform_block.hpp"
#include "common/window.hpp"
#include "step01_cpu_points/ground.hpp"
#include "step04_transform_feedback/no_vertices.hpp"

using namespace snow;

namespace {

// All flakes, a pixel each: one half of their state in either texture, and the framebuffer through
// which both are drawn.
struct State {
    GlObject position_age, velocity_rest, framebuffer;
};

GlObject make_state_texture(ivec2 size, const std::vector<vec4>& pixels)
{
    GlObject texture = make_texture();
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size.x, size.y, 0, GL_RGBA, GL_FLOAT, pixels.data());
    check_memory("the flakes", double(pixels.size() * sizeof(vec4)));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

}  // namespace

void run_texture(Window& window)
{
    const Options& options = window.options();
    const Weather& weather = options.weather;

    std::vector<Particle> flakes = make_flakes(weather);
    uint tick = 0;                  // time steps made so far
    constexpr size_t width = 4096;  // pixels of a row; rows as many as it takes
    const ivec2 size(width, max((flakes.size() + width - 1) / width, size_t(1)));
    std::vector<vec4> position_age(width * size_t(size.y)), velocity_rest(position_age);
    for (size_t i = 0; i < flakes.size(); ++i) {
        position_age[i] = vec4(flakes[i].position, flakes[i].age);
        velocity_rest[i] = vec4(flakes[i].velocity, flakes[i].rest);
    }
    // Ping-pong: an update reads two textures and writes two others.
    State states[2];
    for (State& state : states) {
        state.position_age = make_state_texture(size, position_age);
        state.velocity_rest = make_state_texture(size, velocity_rest);
        state.framebuffer = make_framebuffer();
        glBindFramebuffer(GL_FRAMEBUFFER, state.framebuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                               state.position_age, 0);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D,
                               state.velocity_rest, 0);
        const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
        glDrawBuffers(2, both);
        check_framebuffer("to two RGBA32F textures (try --variant feedback)");
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    int now = 0;           // the state that holds the flakes as they are
    const NoVertices vao;  // the shaders fetch what they need

    UniformBlock<Weather> weather_block;
    Program update({{GL_VERTEX_SHADER, "step04_transform_feedback/full_screen.vert"},
                    {GL_FRAGMENT_SHADER, "step04_transform_feedback/update.frag"}});
    Program flake({{GL_VERTEX_SHADER, "step04_transform_feedback/flake_texture.vert"},
                   {GL_FRAGMENT_SHADER, "step03_shader_points/flake.frag"}});

    glEnable(GL_PROGRAM_POINT_SIZE);  // the size comes from the vertex shader
    glEnable(GL_POINT_SPRITE);        // and gl_PointCoord with it
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glClearColor(0.13f, 0.09f, 0.08f, 1.0f);
    while (window.begin_frame()) {
        glViewport(0, 0, window.size().x, window.size().y);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        draw_ground(window);
        weather_block.update(WEATHER_BLOCK, weather);
        {
            const auto stage = window.stage("update");
            update.use();
            glViewport(0, 0, size.x, size.y);
            for (; window.next_tick(); ++tick) {
                update.set("tick", tick);
                update.set_texture("position_age", POSITION_AGE_UNIT, GL_TEXTURE_2D,
                                   states[now].position_age);
                update.set_texture("velocity_rest", VELOCITY_REST_UNIT, GL_TEXTURE_2D,
                                   states[now].velocity_rest);
                glBindVertexArray(vao);
                glBindFramebuffer(GL_FRAMEBUFFER, states[1 - now].framebuffer);
                glDrawArrays(GL_TRIANGLES, 0, 3);
                now = 1 - now;
            }
            glBindFramebuffer(GL_FRAMEBUFFER, 0);
            glViewport(0, 0, window.size().x, window.size().y);
        }
        {
            const auto stage = window.stage("draw");
            flake.use();
            flake.set("view", window.view());
            flake.set("projection", window.projection());
            flake.set("window_height", float(window.size().y));
            flake.set_texture("position_age", POSITION_AGE_UNIT, GL_TEXTURE_2D,
                              states[now].position_age);
            flake.set_texture("velocity_rest", VELOCITY_REST_UNIT, GL_TEXTURE_2D,
                              states[now].velocity_rest);
            glBindVertexArray(vao);
            glEnable(GL_BLEND);
            glDrawArrays(GL_POINTS, 0, GLsizei(flakes.size()));
            glDisable(GL_BLEND);
        }
        window.swap_buffers();
    }
    glBindTexture(GL_TEXTURE_2D, states[now].position_age);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, position_age.data());
    glBindTexture(GL_TEXTURE_2D, states[now].velocity_rest);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, velocity_rest.data());
    check_read_back("the flakes");
    for (size_t i = 0; i < flakes.size(); ++i) {
        flakes[i] = {vec3(position_age[i]), position_age[i].w, vec3(velocity_rest[i]),
                     velocity_rest[i].w};
    }
    window.dump(flakes);
}
