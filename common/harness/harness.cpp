#include "common/harness/harness.hpp"

#include <GL/glew.h>
#include <GL/freeglut.h>

#include <algorithm>
#include <cctype>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <new>
#include <stdexcept>
#include <utility>

#include "common/harness/driver.hpp"
#include "common/harness/output.hpp"
#include "common/harness/tour.hpp"

#ifndef SIGHUP  // the terminal was closed; Windows does not tell
#define SIGHUP SIGTERM
#endif

static volatile std::sig_atomic_t interrupted = 0;

// The first asks for an end, so that what was computed can be written; a second ends it at once.
static void on_interrupt(int signal)
{
    interrupted = 1;
    std::signal(signal, SIG_DFL);
}

static Harness* the_harness = nullptr;  // GLUT's callbacks are plain functions

Harness::Harness(CommandLine line)
    : command_(std::move(line)), show_panel_(!command_.reproducible()), next_size_(command_.size),
      touring_(command_.tour)
{
    the_harness = this;
    camera_ = command_.camera;
    open_window(command_);
    if (!set_vsync(command_.vsync) && command_.vsync)
        throw std::runtime_error("--vsync: this driver cannot wait for the display");
    panel_.emplace();

    glutDisplayFunc([] {});  // required; the frames are drawn by begin_frame's caller
    glutReshapeFunc([](int width, int height) {
        the_harness->next_size_ = {std::max(width, 1), std::max(height, 1)};
    });
    glutIgnoreKeyRepeat(1);
    glutKeyboardFunc([](unsigned char key, int x, int y) {
        const bool typed = the_harness->show_panel_ && the_harness->panel_->press_key(key, x, y);
        if (!typed) the_harness->press(key);
    });
    glutSpecialFunc([](int key, int x, int y) { the_harness->on_special_key(key, true, x, y); });
    glutSpecialUpFunc([](int key, int x, int y) { the_harness->on_special_key(key, false, x, y); });
    glutMouseFunc(
        [](int button, int state, int x, int y) { the_harness->on_button(button, state, x, y); });
    glutMotionFunc([](int x, int y) { the_harness->on_motion(x, y); });
    glutPassiveMotionFunc([](int x, int y) { the_harness->on_motion(x, y); });
    // freeglut destroys window and context after this. But in X11 a context that is current lives
    // on until it no longer is (GLX 1.4, 3.3.7), so what was computed can still be read back, and
    // objects deleted. Where it would not live on, the window is not closed before the end.
    glutCloseFunc([] { the_harness->on_close(); });
    take_close_button([this] { closing_ = true; });
    begin_run();
    glutMainLoopEvent();  // it is mapped, and may at once be of another size
}

Harness::~Harness()
{
    panel_.reset();  // while there is a context
    glutExit();      // at once; glutDestroyWindow would only queue it for a main loop that is over
}

void Harness::begin_run()
{
    controls_.restart = false;
    drawn_ = drawn_at_last_title_ = 0;
    stands_for_ = 1;
    timer_ = {};
    const double mebibytes =
        double(command_.weather.particles) * sizeof(snow::Particle) / (1 << 20);
    std::printf("%s %s: %s, OpenGL %s, %u flakes of %.*f MiB, %dx%d, vsync %s\n",
                command_.lesson.name.c_str(), command_.variant.c_str(), renderer_name().c_str(),
                reinterpret_cast<const char*>(glGetString(GL_VERSION)), command_.weather.particles,
                mebibytes < 10 ? 1 : 0, mebibytes, command_.size.x, command_.size.y,
                command_.vsync ? "on" : "off");
    if (renders_in_software()) {
        std::puts("warning: OpenGL runs in software here: times say nothing about a graphics card");
        std::string names;
        for (const snow::Parameter& parameter : command_.parameters()) {
            // Once: a user who turns it on later has decided, too.
            if (!parameter.costly || !command_.decided.insert(parameter.name).second) continue;
            parameter.set(0);
            names += std::string(names.empty() ? " " : ", ") + parameter.name;
        }
        if (!names.empty())
            std::printf("left off in software, unless --set NAME=1:%s\n", names.c_str());
    }
    std::fflush(stdout);
}

bool Harness::restarted()
{
    if (closing_ || !controls_.restart) return false;
    begin_run();
    return true;
}

bool Harness::enough() const
{
    return command_.frames && drawn_ >= uint64_t(*command_.frames) + command_.warmup;
}

bool Harness::begin_frame()
{
    if (closing_ || failed_ || enough() || controls_.restart) {
        if (is_watched()) std::fputs("\r\033[K", stderr);
        report();
        return false;
    }
    const Clock::time_point now = Clock::now();
    if (drawn_ == 0) {
        for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
            if (std::signal(number, on_interrupt) == SIG_IGN) std::signal(number, SIG_IGN);
        }
        last_frame_ = last_swap_ = last_title_ = now;
    }
    frame_seconds_ = std::chrono::duration<double>(now - last_frame_).count() / stands_for_;
    last_frame_ = last_events_ = now;
    size_ = next_size_;
    command_.weather.world_max += std::exchange(raise_world_by_, 0.0f);
    pace();
    move_camera();
    // Software renderers answer some queries with 0: there the last frames of a benchmark's warm-up
    // are a pass of its own, in which the stages wait for each other and can be told apart.
    const bool counts = drawn_ >= command_.warmup;
    const unsigned pass = std::min(60u, command_.warmup / 2);
    const bool synchronised =
        command_.benchmark && !counts && drawn_ + pass >= command_.warmup && renders_in_software();
    if (measuring() ? counts || synchronised : show_panel_) timer_.begin_frame(synchronised);
    drawn_ += stands_for_;
    return true;
}

// Says how many time steps the frame is to make: always the same in a run that is to be repeatable.
// Otherwise as many as the clock has moved on; a long hitch slows the snow down, it never skips.
void Harness::pace()
{
    const double time_step = command_.weather.time_step, timelapse = command_.timelapse;
    ticks_ = 0;
    // A warm-up need not be seen: a frame stands for many, until as few as that are left, which are
    // drawn one by one, as those that count will be.
    constexpr unsigned many = 60, few = 8;
    const bool in_warmup = command_.reproducible() && drawn_ + 2 * many <= command_.warmup;
    stands_for_ = in_warmup ? many : 1;
    owed_seconds_ =
        std::min(owed_seconds_ + timelapse * frame_seconds_, few * timelapse * time_step);
    if (controls_.paused) {
        owed_seconds_ = 0;
        due_ = std::exchange(controls_.single_step, false) ? 1 : 0;
    } else if (command_.reproducible()) {
        due_ = int(command_.timelapse * stands_for_);
    } else {
        due_ = int(owed_seconds_ / time_step);
        owed_seconds_ -= due_ * time_step;
    }
}

void Harness::move_camera()
{
    if (flying_ != glm::vec3(0)) {
        touring_ = false;
        camera_.fly(std::max(3.0f, 0.4f * camera_.distance) * float(frame_seconds_) * flying_);
    }
    if (touring_) {
        const float seconds = float(tour_seconds_);
        const Pose pose = terrain_ ? tour_above(*terrain_, seconds) : tour(seconds);
        camera_.look(pose.eye, pose.target);
        // In a reproducible run a frame is a 60th of a second, so that a recording can be repeated.
        if (drawn_ >= command_.warmup)
            tour_seconds_ += command_.reproducible() ? 1 / 60.0 : frame_seconds_;
    }
    if (command_.weather.follow != 0) {
        const glm::vec3 eye = camera_.eye();
        for (snow::Emitter& cloud : command_.weather.emitters)
            cloud.centre = {eye.x, cloud.centre.y, eye.z};
    }
}

bool Harness::next_tick()
{
    using std::chrono::milliseconds;
    if (ticks_ >= due_) return false;
    // However many steps a frame makes, the user is not kept waiting: not for the GPU, which might
    // be as many steps behind; and where the clock says how many, they end after a while.
    if (ticks_ > 0 && ticks_ % 8 == 0) glFinish();
    const Clock::time_point now = Clock::now();
    if (now - last_events_ >= milliseconds(100)) {
        last_events_ = now;
        glutMainLoopEvent();
        if (interrupted) closing_ = true;
    }
    const bool late = !command_.reproducible() && now - last_frame_ > milliseconds(50);
    if (closing_ || (late && ticks_ > 0)) return false;
    ++ticks_;
    return true;
}

void Harness::swap_buffers()
{
    drawn_now_ = true;
    glutMainLoopEvent();
    drawn_now_ = false;
    if (gone_) return;  // and with it what was drawn
    save_frame();
    if (show_panel_) {
        const Stage panel = stage("panel");
        panel_->draw(size(), command_, controls_, timer_.frames(), renderer_name());
        if (controls_.key != 0) press(std::exchange(controls_.key, 0));
    }
    glutSwapBuffers();
    const Clock::time_point now = Clock::now();
    timer_.end_frame(std::chrono::duration<double, std::milli>(now - last_swap_).count(),
                     measuring() ? SIZE_MAX : 300);
    last_swap_ = now;
    show_frame_time();
}

void Harness::save_frame()
{
    if (interrupted) closing_ = true;
    const auto save = [this](const std::filesystem::path& path, bool matters = true) {
        attempt([&] { write_file(path, png_of_back_buffer(size_)); }, matters);
    };
    if ((closing_ || enough()) && !command_.screenshot.empty()) save(command_.screenshot);
    if (drawn_ > command_.warmup && !command_.record.empty()) {
        const std::string number = std::to_string(1'000'000 + drawn_ - command_.warmup);
        save(command_.record / (number.substr(1) + ".png"));
    }
    // Where this one cannot be written it is no reason to end the run and lose its results.
    if (std::exchange(controls_.save_picture, false)) save(command_.lesson.name + ".png", false);
}

void Harness::show_frame_time()
{
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - last_title_).count();
    if (seconds < 0.5) return;
    last_title_ = now;
    if (command_.reproducible()) {
        if (is_watched())
            std::fprintf(stderr, "\rframe %u of %u", unsigned(drawn_),
                         *command_.frames + command_.warmup);
        return;
    }
    const double frames = double(drawn_ - drawn_at_last_title_);
    char title[128];
    std::snprintf(title, sizeof title, "%s %s   %.2f ms a frame, %.0f fps",
                  command_.lesson.name.c_str(), command_.variant.c_str(), 1000 * seconds / frames,
                  frames / seconds);
    set_title(title);
    drawn_at_last_title_ = drawn_;
}

void Harness::report()
{
    if (!measuring()) return;
    timer_.finish();
    if (command_.benchmark) {
        print_summary(timer_.frames());
        if (!enough()) std::puts("benchmark: cut short");
    }
    if (command_.csv.empty()) return;
    attempt([&] {
        write_file(command_.csv, csv_of(timer_.frames(), command_, size(), renderer_name()));
    });
}

void Harness::stand_on(const Terrain& terrain)
{
    terrain_ = terrain;
    // Clouds hang as high above it as elsewhere above y = 0: see step05_collision/terrain.glsl.
    // From the first frame on: flakes that wait for their birth do so where they always do.
    raise_world_by_ = terrain.highest({0, 0}, terrain.half_size);
}

void Harness::dump(const std::vector<snow::Particle>& flakes)
{
    if (!command_.dump.empty()) attempt([&] { write_dump(command_.dump, flakes); });
}

// Does something without which the rest goes on: a failure is told, and remembered if it matters.
void Harness::attempt(const std::function<void()>& action, bool matters)
try {
    action();
} catch (const std::runtime_error& failure) {
    std::cerr << (matters ? "error: " : "warning: ") << failure.what() << std::endl;
    failed_ |= matters;
}

void Harness::on_close()
{
    closing_ = gone_ = true;
    if (drawn_now_) save_frame();
}

void Harness::press(unsigned char key)
{
    const int letter = std::tolower(key);
    if (letter == escape_key) closing_ = true;
    if (letter == 'c') {
        camera_ = command_.camera;
        touring_ = false;
    }
    if (letter == 'h') {
        show_panel_ = !show_panel_;
        panel_->let_go();
    }
    if (letter == ' ') controls_.paused = !controls_.paused;
    if (letter == 'r') controls_.restart = true;
    if (letter == 's') controls_.save_picture = true;
    if (letter == 't') touring_ = !touring_;
    for (const snow::Parameter& parameter : command_.parameters()) {
        if (parameter.key != 0 && std::toupper(key) == parameter.key)
            parameter.set(1 - parameter.get());
    }
}

void Harness::on_special_key(int key, bool down, int x, int y)
{
    if (panel_->press_special_key(key, down, x, y) && show_panel_ && down) return;
    const float held = down ? 1.0f : 0.0f;
    if (key == GLUT_KEY_LEFT) flying_.x = -held;
    if (key == GLUT_KEY_RIGHT) flying_.x = held;
    if (key == GLUT_KEY_PAGE_DOWN) flying_.y = -held;
    if (key == GLUT_KEY_PAGE_UP) flying_.y = held;
    if (key == GLUT_KEY_DOWN) flying_.z = -held;
    if (key == GLUT_KEY_UP) flying_.z = held;
    if (key == GLUT_KEY_F11 && down) glutFullScreenToggle();
}

void Harness::on_button(int button, int state, int x, int y)
{
    mouse_ = {x, y};
    dragging_ = panning_ = false;
    if (show_panel_ && panel_->press_button(button, state, x, y)) return;
    if (state != GLUT_DOWN) return;
    if (wheel_notches(button) != 0) camera_.zoom(float(wheel_notches(button)));
    panning_ = button == GLUT_RIGHT_BUTTON || (glutGetModifiers() & GLUT_ACTIVE_SHIFT) != 0;
    dragging_ = button == GLUT_LEFT_BUTTON || button == GLUT_RIGHT_BUTTON;
}

void Harness::on_motion(int x, int y)
{
    panel_->move_mouse(x, y);
    const glm::ivec2 mouse(x, y);
    const glm::vec2 way = mouse - mouse_;
    if (dragging_) touring_ = false;
    if (dragging_ && panning_) camera_.pan(way, size_.y);
    if (dragging_ && !panning_) camera_.orbit(way);
    mouse_ = mouse;
}

int run_lesson(int argc, char** argv, const Lesson& lesson)
try {
    Harness window(parse_command_line(argc, argv, lesson));
    do window.options().chosen().run(window);
    while (window.restarted());
    return window.failed() ? 1 : 0;
} catch (const std::bad_alloc&) {
    std::cerr << "error: not enough memory (try fewer --particles or --voxels)" << std::endl;
    return 1;
} catch (const std::exception& failure) {
    std::cerr << "error: " << failure.what() << std::endl;
    return 1;
}
