#include "common/harness/timer.hpp"

#include <stdexcept>

#include "common/harness/driver.hpp"
#include "common/window.hpp"

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

bool has_queries()
{
    static const bool has = has_extension("GL_ARB_timer_query");
    return has;
}

GLint timestamp_bits()
{
    static const GLint bits = [] {
        GLint count = 0;
        glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &count);
        return count;
    }();
    return bits;
}

}  // namespace

GLuint64 nanoseconds_between(GLuint64 begin, GLuint64 end, GLint bits)
{
    const GLuint64 mask = bits > 0 && bits < 64 ? (GLuint64(1) << bits) - 1 : ~GLuint64(0);
    return (end - begin) & mask;
}

StageTimer::StageTimer(FrameTimer* timer, const char* name) : timer_(timer)
{
    if (timer_ != nullptr) timer_->begin_stage(name);
}

StageTimer::~StageTimer()
{
    if (timer_ != nullptr) timer_->end_stage();
}

void FrameTimer::begin_stage(const char* name)
{
    if (running_) throw std::logic_error(std::string("stage ") + name + " within a stage");
    running_ = true;
    FrameTime& frame = frames_.back();
    frame.stages.push_back({name, 0, {}});
    if (frame.synchronised) {
        glFinish();
    } else if (has_queries()) {
        pending_.push_back(
            {forgotten_ + frames_.size() - 1, frame.stages.size() - 1, take_query(), take_query()});
        glQueryCounter(pending_.back().begin, GL_TIMESTAMP);
    }
    stage_begin_ = Clock::now();
}

void FrameTimer::end_stage()
{
    FrameTime& frame = frames_.back();
    StageTime& stage = frame.stages.back();
    stage.cpu_ms = milliseconds_since(stage_begin_);
    if (frame.synchronised) {
        glFinish();
        stage.gpu_ms = milliseconds_since(stage_begin_);
    } else if (has_queries()) {
        glQueryCounter(pending_.back().end, GL_TIMESTAMP);
    }
    running_ = false;
}

void FrameTimer::begin_frame(bool synchronised)
{
    frames_.push_back({0, synchronised, {}});
    open_ = true;
}

void FrameTimer::end_frame(double frame_ms)
{
    if (!open_) return;
    frames_.back().frame_ms = frame_ms;
    open_ = false;
    collect(false);
}

void FrameTimer::drop_frame()
{
    if (!open_) return;
    frames_.pop_back();
    open_ = false;
}

void FrameTimer::keep(size_t count)
{
    while (frames_.size() > count) {
        frames_.pop_front();
        ++forgotten_;
    }
}

void FrameTimer::clear()
{
    keep(0);
    open_ = false;
}

void FrameTimer::finish()
{
    collect(true);
}

// Takes in the timestamps that have arrived. The queries are answered in the order in which they
// were made, so the first that is not ready ends it; asking for its result would stall until it is.
void FrameTimer::collect(bool wait)
{
    while (!pending_.empty()) {
        const Pending& oldest = pending_.front();
        GLint ready = 0;
        if (!wait) glGetQueryObjectiv(oldest.end, GL_QUERY_RESULT_AVAILABLE, &ready);
        if (!wait && !ready) return;
        GLuint64 begin = 0, end = 0;  // ns
        glGetQueryObjectui64v(oldest.begin, GL_QUERY_RESULT, &begin);
        glGetQueryObjectui64v(oldest.end, GL_QUERY_RESULT, &end);
        if (oldest.frame >= forgotten_ && oldest.frame - forgotten_ < frames_.size()) {
            frames_[oldest.frame - forgotten_].stages[oldest.stage].gpu_ms =
                double(nanoseconds_between(begin, end, timestamp_bits())) * 1e-6;
        }
        free_queries_.insert(free_queries_.end(), {oldest.begin, oldest.end});
        pending_.pop_front();
    }
}

// As many query objects as the GPU is frames behind, used again and again; they go with the
// context.
GLuint FrameTimer::take_query()
{
    if (free_queries_.empty()) {
        free_queries_.resize(16);
        glGenQueries(16, free_queries_.data());
    }
    const GLuint query = free_queries_.back();
    free_queries_.pop_back();
    return query;
}

double FrameTimer::cost_of_a_stage()
{
    constexpr int count = 1000;
    FrameTimer timer;
    timer.begin_frame(false);
    const Clock::time_point begin = Clock::now();
    for (int i = 0; i < count; ++i) StageTimer(&timer, "empty");
    const double cost = milliseconds_since(begin) / count;
    timer.finish();
    glDeleteQueries(GLsizei(timer.free_queries_.size()), timer.free_queries_.data());
    return cost;
}
