// Three ways to hand a fresh array to the GPU every frame. They draw the same picture; they differ
// in who waits for whom.
#pragma once

#include <GL/glew.h>

#include <cstring>
#include <string>

#include "common/gl_object.hpp"
#include "common/snow.hpp"

class StreamBuffer {
public:
    // `way` is "subdata", "orphan" or "persistent"; the last needs OpenGL 4.4 or
    // GL_ARB_buffer_storage.
    StreamBuffer(const std::string& way, size_t flakes)
        : way_(way), bytes_(GLsizeiptr(flakes * sizeof(snow::Particle))), buffer_(make_buffer())
    {
        glBindBuffer(GL_ARRAY_BUFFER, buffer_);
        if (way_ == "persistent") {
            constexpr GLbitfield access =
                GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
            const GLsizeiptr all =
                regions * bytes_ > 0 ? regions * bytes_ : 1;  // none may be empty
            glBufferStorage(GL_ARRAY_BUFFER, all, nullptr, access);
            mapped_ = static_cast<char*>(glMapBufferRange(GL_ARRAY_BUFFER, 0, all, access));
        } else {
            glBufferData(GL_ARRAY_BUFFER, bytes_, nullptr, GL_STREAM_DRAW);
        }
    }
    ~StreamBuffer()
    {
        for (GLsync fence : fences_) glDeleteSync(fence);  // which ignores null
    }
    StreamBuffer(const StreamBuffer&) = delete;
    StreamBuffer& operator=(const StreamBuffer&) = delete;

    // Uploads the flakes and leaves the buffer bound. Returns where in it they begin, in flakes.
    GLint upload(const std::vector<snow::Particle>& flakes)
    {
        glBindBuffer(GL_ARRAY_BUFFER, buffer_);
        if (way_ == "subdata") {
            // Into the storage that last frame's draw may still be reading: the driver copies or
            // waits.
            glBufferSubData(GL_ARRAY_BUFFER, 0, bytes_, flakes.data());
            return 0;
        }
        if (way_ == "orphan") {
            // New storage every frame; the old one lives on, an orphan, until the GPU is done with
            // it.
            glBufferData(GL_ARRAY_BUFFER, bytes_, flakes.data(), GL_STREAM_DRAW);
            return 0;
        }
        // Persistent: memory the GPU reads directly. Nobody waits for us, so we wait, for the fence
        // that stands behind the draw of three frames ago from the region we are about to
        // overwrite.
        region_ = (region_ + 1) % regions;
        if (fences_[region_] != nullptr) {
            glClientWaitSync(fences_[region_], GL_SYNC_FLUSH_COMMANDS_BIT, GL_TIMEOUT_IGNORED);
            glDeleteSync(fences_[region_]);
            fences_[region_] = nullptr;
        }
        if (bytes_ > 0) std::memcpy(mapped_ + region_ * bytes_, flakes.data(), size_t(bytes_));
        return GLint(region_ * GLsizeiptr(flakes.size()));
    }

    GLuint name() const { return buffer_; }

    // To be called after the draw calls that read what was uploaded.
    void drawn()
    {
        if (way_ == "persistent") fences_[region_] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    }

private:
    static constexpr GLsizeiptr regions = 3;
    std::string way_;
    GLsizeiptr bytes_;  // of one frame's flakes
    GlObject buffer_;
    char* mapped_ = nullptr;
    GLsizeiptr region_ = 0;
    GLsync fences_[regions] = {};
};
