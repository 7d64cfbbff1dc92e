#include "common/harness/harness.hpp"

#include <GL/glew.h>
#include <GL/freeglut.h>

#include <cctype>
#include <cstdio>
#include <imgui.h>
#include <imgui_impl_glut.h>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "common/harness/benchmark.hpp"
#include "common/harness/driver.hpp"
#include "common/harness/dump.hpp"
#include "common/harness/process.hpp"
#include "common/harness/recorder.hpp"
#include "common/harness/tour.hpp"
#include "common/harness/window_system.hpp"
#include "common/window.hpp"

Harness::Harness(CommandLine line) : command(std::move(line)), show_panel_(!command.reproducible())
{
    controls.touring = command.tour;
}

void Harness::begin_run()
{
    controls.restart = false;
    drawn_ = drawn_at_last_title_ = 0;
    frames_in_last_ = 1;
    timer.clear();
    software_ = renders_in_software();
    const unsigned flakes = command.weather.particles;
    check_memory_for_flakes(flakes, software_, free_memory());
    const double size = size_of_flakes(flakes);
    char mebibytes[16];
    std::snprintf(mebibytes, sizeof mebibytes, "%.*f", size < 10 ? 1 : 0, size);
    std::cout << command.lesson.name << " " << command.variant << ": " << renderer_name()
              << ", OpenGL " << glGetString(GL_VERSION) << ", " << flakes << " flakes of "
              << mebibytes << " MiB, " << command.size.x << "x" << command.size.y << ", vsync "
              << vsync_state() << std::endl;
    if (software_) {
        std::cout
            << "warning: OpenGL runs in software here: times say nothing about a graphics card"
            << std::endl;
        leave_off_what_is_costly();
    }
    last_frame_ = last_swap_ = last_title_ = Clock::now();
}

void Harness::leave_off_what_is_costly()
{
    std::string names;
    for (const snow::Parameter& parameter : command.parameters()) {
        // Once: who turns it on later has decided, too.
        if (!parameter.costly || !command.decided.insert(parameter.name).second) continue;
        parameter.set(0);
        names += std::string(names.empty() ? "" : ", ") + parameter.name;
    }
    if (!names.empty())
        std::cout << "left off in software, unless --set NAME=1: " << names << std::endl;
}

bool Harness::enough() const
{
    return command.frames && drawn_ >= uint64_t(*command.frames) + command.warmup;
}

void Harness::begin_frame(Camera& camera)
{
    const Clock::time_point now = Clock::now();
    frame_seconds = std::chrono::duration<double>(now - last_frame_).count() / frames_in_last_;
    last_frame_ = last_events_ = now;
    frames_in_last_ = frames_in_one(command, drawn_);
    pacing.begin_frame(command, frame_seconds, frames_in_last_, controls);
    if (controls.touring) {
        const Pose pose =
            terrain ? tour_above(*terrain, float(tour_time_)) : tour(float(tour_time_));
        camera.look(pose.eye, pose.target);
        // In a reproducible run a frame is a 60th of a second, so that a recording can be repeated.
        if (drawn_ >= command.warmup)
            tour_time_ += command.reproducible() ? 1 / 60.0 : frame_seconds;
    }
    snow::Weather& weather = command.weather;
    if (weather.follow != 0) {
        const glm::vec3 eye = camera.eye();
        for (snow::Emitter& cloud : weather.emitters) cloud.centre = {eye.x, cloud.centre.y, eye.z};
    }
    const Timing timing = measuring()   ? timing_of_frame(command, drawn_, software_)
                          : show_panel_ ? Timing::queries
                                        : Timing::off;
    if (timing != Timing::off) timer.begin_frame(timing == Timing::synchronised);
    drawn_ += frames_in_last_;
}

void Harness::record(glm::ivec2 size, bool last)
{
    const uint64_t number = drawn_ > command.warmup ? drawn_ - command.warmup : 0;
    attempt([&] {
        record_frame(command, number, last, std::exchange(controls.save_picture, false),
                     [size] { return read_back_buffer(size); });
    });
}

void Harness::draw_panel(glm::ivec2 size)
{
    if (!show_panel_) return;
    const StageTimer stage(timer.open() ? &timer : nullptr, "panel");
    if (panel_ == nullptr) panel_ = std::make_unique<Panel>();
    panel_->draw(size, command, controls, timer.frames(), renderer_name());
}

void Harness::frame_shown()
{
    const Clock::time_point now = Clock::now();
    timer.end_frame(std::chrono::duration<double, std::milli>(now - last_swap_).count());
    if (!measuring()) timer.keep(300);
    last_swap_ = now;
    if (!command.reproducible()) show_frame_time();
}

bool Harness::events_are_due()
{
    constexpr int few = 8;  // a frame makes no more without --timelapse: those are not held up
    if (pacing.ticks() > 0 && pacing.ticks() % few == 0) glFinish();
    const Clock::time_point now = Clock::now();
    if (now - last_events_ < std::chrono::milliseconds(100)) return false;
    last_events_ = now;
    return true;
}

void Harness::report(glm::ivec2 size)
{
    if (!measuring()) return;
    timer.finish();
    if (command.benchmark) {
        print_summary(timer.frames());
        const uint64_t asked = uint64_t(*command.frames) + command.warmup;
        if (drawn_ < asked) {
            std::cout << "benchmark: cut short after " << drawn_ << " of " << asked
                      << " frames, warm-up included" << std::endl;
        }
    }
    if (!command.csv.empty()) {
        attempt([&] { write_csv(command.csv, command, size, renderer_name(), timer.frames()); });
    }
}

void Harness::attempt(const std::function<void()>& action)
try {
    action();
} catch (const std::runtime_error& failure) {
    std::cerr << "error: " << failure.what() << std::endl;
    failed_ = true;
}

void Harness::show_frame_time()
{
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - last_title_).count();
    if (seconds < 0.5) return;
    const uint64_t frames = drawn_ - drawn_at_last_title_;
    char title[128];
    std::snprintf(title, sizeof title, "%s %s   %.2f ms a frame, %.0f fps",
                  command.lesson.name.c_str(), command.variant.c_str(),
                  1000 * seconds / double(frames), double(frames) / seconds);
    set_title(title);
    last_title_ = now;
    drawn_at_last_title_ = drawn_;
}

// A panel that is hidden listens, too, or it would take a key for one held down that was let go
// meanwhile.
void Harness::let_panel_listen()
{
    glutKeyboardUpFunc([](unsigned char key, int x, int y) {
        if (ImGui::GetCurrentContext() != nullptr) ImGui_ImplGLUT_KeyboardUpFunc(key, x, y);
    });
    glutSpecialFunc([](int key, int x, int y) {
        if (ImGui::GetCurrentContext() != nullptr) ImGui_ImplGLUT_SpecialFunc(key, x, y);
    });
    glutSpecialUpFunc([](int key, int x, int y) {
        if (ImGui::GetCurrentContext() != nullptr) ImGui_ImplGLUT_SpecialUpFunc(key, x, y);
    });
}

bool Harness::panel_takes_key(unsigned char key, int x, int y)
{
    if (!show_panel_ || panel_ == nullptr) return false;
    ImGui_ImplGLUT_KeyboardFunc(key, x, y);
    return panel_->wants_keys();  // a number is being typed into a slider
}

bool Harness::panel_takes_button(int button, int state, int x, int y)
{
    if (!show_panel_ || panel_ == nullptr) return false;
    if (button == wheel_up || button == wheel_down) {
        if (state == GLUT_DOWN) ImGui_ImplGLUT_MouseWheelFunc(0, button == wheel_up ? 1 : -1, x, y);
    } else {
        ImGui_ImplGLUT_MouseFunc(button, state, x, y);
    }
    panel_->set_control_key((glutGetModifiers() & GLUT_ACTIVE_CTRL) != 0);  // it types a number
    return panel_->wants_mouse();
}

void Harness::panel_sees_mouse(int x, int y)
{
    if (panel_ != nullptr) ImGui_ImplGLUT_MotionFunc(x, y);
}

void Harness::on_key(unsigned char key)
{
    switch (std::tolower(key)) {
    case 'h':
        show_panel_ = !show_panel_;
        if (panel_ != nullptr) panel_->let_go();
        break;
    case ' ':
        controls.paused = !controls.paused;
        break;
    case 'r':
        controls.restart = true;
        break;
    case 's':
        controls.save_picture = true;
        break;
    case 't':
        controls.touring = !controls.touring;
        break;
    default:
        for (const snow::Parameter& parameter : command.parameters()) {
            if (parameter.key != 0 && std::toupper(key) == parameter.key)
                parameter.set(1 - parameter.get());
        }
        break;
    }
}

// ---- What the window does no more than hand on.

StageTimer Window::stage(const char* name)
{
    return StageTimer(harness_->timer.open() ? &harness_->timer : nullptr, name);
}

int Window::ticks() const
{
    return harness_->pacing.ticks();
}

double Window::frame_seconds() const
{
    return harness_->frame_seconds;
}

void Window::stand_on(const Terrain& terrain)
{
    harness_->terrain = terrain;
    // Clouds hang as high above it as elsewhere above y = 0: see step05_collision/terrain.glsl.
    harness_->command.weather.world_max.y += terrain.highest({0, 0}, terrain.half_size);
}

void Window::note(const std::string& line)
{
    harness_->controls.note = line;
}

void Window::dump(const std::vector<snow::Particle>& flakes) const
{
    harness_->attempt([&] { dump_flakes(harness_->command.dump, flakes); });
}
