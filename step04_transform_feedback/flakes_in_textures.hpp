// The variant "texture": the flakes' state lies in floating-point textures and a full-screen pass
// of a fragment shader updates it, as GPUs did it before transform feedback (Introduction to
// Computer Graphics project sheet, part 3: "the integration can be done in the fragment shader").
#pragma once

#include <GL/glew.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "common/program.hpp"

class FlakesInTextures {
public:
    explicit FlakesInTextures(const std::vector<snow::Particle>& flakes)
        : size_(width, std::max(1, int((flakes.size() + width - 1) / width))),
          update_({{GL_VERTEX_SHADER, "step04_transform_feedback/full_screen.vert"},
                   {GL_FRAGMENT_SHADER, "step04_transform_feedback/update.frag"}})
    {
        GLint largest = 0;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
        if (size_.y > largest)
            throw std::runtime_error("--particles: too many for this card's textures");

        std::vector<glm::vec4> position_age(size_t(size_.x) * size_t(size_.y)),
            velocity_rest(position_age);
        for (size_t i = 0; i < flakes.size(); ++i) {
            position_age[i] = {flakes[i].position, flakes[i].age};
            velocity_rest[i] = {flakes[i].velocity, flakes[i].rest};
        }
        for (State* state : {&old_, &new_}) {
            state->position_age = make_state_texture(position_age);
            state->velocity_rest = make_state_texture(velocity_rest);
            state->framebuffer = make_framebuffer();
            glBindFramebuffer(GL_FRAMEBUFFER, state->framebuffer);
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                                   state->position_age, 0);
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D,
                                   state->velocity_rest, 0);
            const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
            glDrawBuffers(2, both);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }

    // Reads the old textures, writes the new ones, and swaps their roles.
    void update(unsigned step)
    {
        GLint viewport[4];
        glGetIntegerv(GL_VIEWPORT, viewport);
        glViewport(0, 0, size_.x, size_.y);
        glBindFramebuffer(GL_FRAMEBUFFER, new_.framebuffer);
        update_.use();
        update_.set("step_number", step);
        bind(update_);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
        std::swap(old_, new_);
    }

    // Gives the program in use the textures that hold the flakes as they are.
    void bind(Program& program) const
    {
        program.set("position_age", 0);
        program.set("velocity_rest", 1);
        glActiveTexture(GL_TEXTURE1);
        glBindTexture(GL_TEXTURE_2D, old_.velocity_rest);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, old_.position_age);
    }

    // Reads all flakes back: for the dump, never within a frame.
    void read(std::vector<snow::Particle>& flakes) const
    {
        std::vector<glm::vec4> position_age(size_t(size_.x) * size_t(size_.y)),
            velocity_rest(position_age);
        glBindTexture(GL_TEXTURE_2D, old_.position_age);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, position_age.data());
        glBindTexture(GL_TEXTURE_2D, old_.velocity_rest);
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, velocity_rest.data());
        for (size_t i = 0; i < flakes.size(); ++i) {
            flakes[i] = {glm::vec3(position_age[i]), position_age[i].w, glm::vec3(velocity_rest[i]),
                         velocity_rest[i].w};
        }
    }

private:
    static constexpr int width = 4096;  // pixels of a row; rows as many as it takes

    struct State {
        GlObject position_age, velocity_rest, framebuffer;
    };

    GlObject make_state_texture(const std::vector<glm::vec4>& pixels) const
    {
        GlObject texture = make_texture();
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size_.x, size_.y, 0, GL_RGBA, GL_FLOAT,
                     pixels.data());
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        return texture;
    }

    glm::ivec2 size_;
    State old_, new_;
    Program update_;
};
