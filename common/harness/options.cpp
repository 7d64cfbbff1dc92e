#include "common/harness/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "common/files.hpp"
#include "common/harness/output.hpp"

namespace {

// NaN is not.
bool is_within(float value, float least, float most)
{
    return value >= least && value <= most;
}

std::string parameters_help(CommandLine command)
{
    command.weather = snow::make_weather("snow", 0, 0);
    std::ostringstream text;
    text << "For --set NAME=VALUE (value here: in snow):\n";
    for (const snow::Parameter& parameter : command.parameters()) {
        text << "  " << std::left << std::setw(13) << parameter.name << " " << parameter.get()
             << " " << parameter.unit << ", " << parameter.meaning
             << (parameter.costly ? " (0 in software)" : "") << "\n";
    }
    return text.str();
}

// Changes the one parameter that `setting`, "name=value", names. Throws CLI::ValidationError.
void apply_setting(const std::string& setting, CommandLine& command)
{
    const std::string name = setting.substr(0, setting.find('='));
    const char* const text = setting.c_str() + std::min(name.size() + 1, setting.size());
    for (const snow::Parameter& parameter : command.parameters()) {
        if (name != parameter.name) continue;
        char* end = nullptr;
        const float value = std::strtof(text, &end);
        if (end == text || *end != '\0' ||
            !is_within(value, parameter.minimum, parameter.maximum) ||
            (parameter.is_switch() && value != 0 && value != 1)) {
            std::ostringstream range;
            range << name << " takes " << parameter.minimum << " to " << parameter.maximum << " "
                  << parameter.unit << ", not '" << setting << "'";
            throw CLI::ValidationError("--set", range.str());
        }
        parameter.set(value);
        command.decided.insert(name);
        return;
    }
    throw CLI::ValidationError("--set", "no parameter is called '" + name + "', see --help");
}

// numbers: azimuth and elevation in degrees, and distance in m, within what the mouse can do.
void place_camera(const std::vector<float>& numbers, Camera& camera)
{
    if (!is_within(numbers[0], -360, 360) || !is_within(numbers[1], -2, 85) ||
        !is_within(numbers[2], 0.5f, 80)) {
        throw CLI::ValidationError("--camera", "takes -360 to 360 degrees, -2 to 85 degrees and "
                                               "0.5 to 80 m");
    }
    camera.azimuth = glm::radians(numbers[0]);
    camera.elevation = glm::radians(numbers[1]);
    camera.distance = numbers[2];
}

// The scene of that name, or the file. What it is entered with is set in `command`; `camera` stays
// as it is if the user has placed it.
void enter_scene(const std::string& name, CommandLine& command, std::vector<float>& camera)
{
    command.scene = path_of(name);
    if (name == "courtyard" || name == "mountains")
        command.scene = find_file("common/assets/" + name + ".obj");
    if (name == "mountains") {
        command.metres = true;
        command.weather.follow = 1;
        command.weather.snowfall *= 0.4f;
        if (camera.empty()) camera = {75, 9, 48};  // in the mouth of their valley
    }
    if (name == "none" || std::filesystem::exists(command.scene)) return;
    throw std::runtime_error("cannot read " + name + ": no such file, nor one of the scenes " +
                             "courtyard, mountains and none");
}

}  // namespace

std::string keys_help(const std::vector<snow::Parameter>& parameters)
{
    std::string help =
        "Mouse: drag to orbit, wheel to zoom, right button or Shift to pan. Arrows,\n"
        "page up, page down: fly. F11: full screen. C: camera back. T: tour.\n"
        "H: panel. Space: pause. R: restart. S: screenshot. Escape: quit.";
    for (const snow::Parameter& parameter : parameters) {
        if (parameter.key == 0) continue;
        help += std::string(" ") + parameter.key + ": " + parameter.name + ".";
    }
    return help;
}

const Variant& CommandLine::chosen() const
{
    return *std::find_if(lesson.variants.begin(), lesson.variants.end(),
                         [this](const Variant& one) { return one.name == variant; });
}

std::vector<snow::Parameter> CommandLine::parameters()
{
    std::vector<snow::Parameter> all = snow::weather_parameters(weather);
    const std::vector<snow::Parameter>& own = chosen().parameters;
    all.insert(all.end(), own.begin(), own.end());
    return all;
}

CommandLine parse_command_line(int argc, char** argv, const Lesson& lesson)
{
    CommandLine command;
    command.lesson = lesson;
    command.variant = lesson.variants.front().name;
    std::vector<std::string> variants;
    for (const Variant& variant : lesson.variants) variants.push_back(variant.name);
    unsigned particles = 20000, seed = 1;
    std::string preset = "snow", scene = "courtyard";
    std::vector<int> size = {command.size.x, command.size.y};
    std::vector<float> camera;
    std::vector<std::string> settings;
    bool follow = false;

    CLI::App app(lesson.name + ": " + lesson.idea);
    const auto add_path = [&app](const char* name, std::filesystem::path& path, const char* what) {
        return app.add_option_function<std::string>(
            name, [&path](const std::string& text) { path = path_of(text); }, what);
    };
    app.add_option("--particles", particles, "flakes in the pool (20000)")
        ->check(CLI::Range(0u, snow::max_particles));
    app.add_option("--variant", command.variant, "way of doing it (" + command.variant + ")")
        ->check(CLI::IsMember(variants));
    app.add_option("--weather", preset, "kind of weather (snow)")
        ->check(CLI::IsMember({"snow", "rain", "hail"}));
    app.add_option("--set", settings,
                   "NAME=VALUE, a number of the weather or of the step (list below)")
        ->allow_extra_args(false);
    if (lesson.has_scene) {
        app.add_option("--scene", scene,
                       "OBJ file to snow on, none, courtyard, or mountains, which has --metres, "
                       "--follow, and less snow, or nobody would see them (courtyard)");
        add_path("--collision", command.collision,
                 "OBJ file to land on instead, in the scene's coordinates (the scene)");
        app.add_option("--up", command.up, "axis that points up in those files (y)")
            ->check(CLI::IsMember({"y", "z"}));
        app.add_flag("--follow", follow,
                     "keep the clouds above the camera, 40 m of them with --metres (they stay)");
        app.add_flag("--metres", command.metres,
                     "those files are in metres: keep their size, up to 2 km (fit it to 16 m)");
        app.add_option("--voxels", command.voxels,
                       "voxels along the scene's longest axis (256): a power of two")
            ->check(CLI::IsMember({32, 64, 128, 256, 512, 1024}));
        app.add_option("--voxeliser", command.voxeliser, "where their grid is made (cpu)")
            ->check(CLI::IsMember({"cpu", "gpu"}));
    }
    if (lesson.fixed_points) {
        app.add_option("--groups", command.groups, "pieces in which the pool is drawn (2)")
            ->check(CLI::Range(1u, 1000000u));
        app.add_option("--point-size", command.point_size,
                       "pixels of emitter 0's points, half of emitter 1's: 0.1 to 64 (1)");
    }
    app.add_option("--seed", seed, "another seed, another snowfall (1)");
    app.add_option("--size", size, "of the window, pixels (1280x720)")
        ->delimiter('x')
        ->expected(2)
        ->check(CLI::Range(1, 16384))
        ->type_name("WIDTHxHEIGHT");
    app.add_flag("--fullscreen", command.fullscreen, "fill the screen (F11 does it, too)");
    app.add_option("--camera", camera, "from the middle, degrees and m (41.25,15.47,17.5)")
        ->delimiter(',')
        ->expected(3)
        ->type_name("AZIMUTH,ELEVATION,DISTANCE");
    app.add_flag("--tour", command.tour,
                 "fly the camera through the courtyard, or around a scene in --metres");
    CLI::Option* vsync = app.add_flag("--vsync", command.vsync,
                                      "wait for the display (off, so that times can be compared)");
    app.add_option("--frames", command.frames, "number of frames to stop after (run until closed)");
    app.add_option("--warmup", command.warmup,
                   "frames before the first that counts (0), all but some 60 in time lapse");
    app.add_option("--timelapse", command.timelapse, "how many times as fast it snows (1)")
        ->check(CLI::Range(1u, 1000u));
    app.add_flag("--benchmark", command.benchmark,
                 "measure: panel hidden, --warmup 960 (until all snow is out), --frames 300, one "
                 "time step in each that counts")
        ->excludes(vsync);
    add_path("--csv", command.csv, "write the times of every frame to this file");
    app.add_flag("--realtime", command.realtime,
                 "follow the clock even with --frames, --dump or --screenshot (one step a frame)");
    add_path("--record", command.record, "write every frame to a PNG file in this folder");
    add_path("--screenshot", command.screenshot, "write the last frame to this PNG file");
    add_path("--dump", command.dump, "write all flakes to this CSV file after the last frame");
    if (lesson.has_cover) {
        add_path("--dump-cover", command.dump_cover,
                 "write the mass of lying snow, cell by cell, to this CSV file");
        app.add_option_function<std::string>(
            "--hold-fps",
            [&settings](const std::string& fps) { settings.push_back("hold_fps=" + fps); },
            "frame rate to hold by moving fewer flakes");
    }
    app.add_flag("--debug", command.debug, "OpenGL debug context, messages to stderr");

    // No option takes nothing: an unset variable in a script is a mistake, not a wish.
    const CLI::Validator not_empty(
        [](const std::string& text) { return text.empty() ? "must not be empty" : ""; }, "");
    for (CLI::Option* option : app.get_options()) {
        if (option->get_items_expected_max() > 0) option->check(not_empty);
    }
    try {
        app.parse(argc, argv);
        if (!is_within(command.point_size, 0.1f, 64))
            throw CLI::ValidationError("--point-size", "takes 0.1 to 64 pixels");
        command.size = {size[0], size[1]};
        command.weather = snow::make_weather(preset, particles, seed);
        if (follow) command.weather.follow = 1;
        if (lesson.has_scene) enter_scene(scene, command, camera);
        if (!camera.empty()) place_camera(camera, command.camera);
        if (command.metres && command.weather.follow != 0) {
            // In a landscape one sees the end of the snow under clouds as wide as the courtyard.
            for (snow::Emitter& cloud : command.weather.emitters)
                cloud.half_size.x = cloud.half_size.z = 20;
        }
        for (const std::string& setting : settings) apply_setting(setting, command);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help() << "\n"
                  << parameters_help(command) << "\n"
                  << keys_help(command.parameters()) << "\n";
        std::exit(0);
    } catch (const CLI::ParseError& error) {
        std::cerr << lesson.name << ": " << error.what() << " (try --help)\n";
        std::exit(2);
    }
    for (const auto& output : {command.screenshot, command.dump, command.dump_cover, command.csv}) {
        if (!output.empty()) check_writable(output);
    }
    if (!command.record.empty()) {
        std::error_code error;  // is shown by what follows
        std::filesystem::create_directories(command.record, error);
        if (std::filesystem::exists(command.record / "000001.png"))
            throw std::runtime_error("cannot record into " + command.record.string() +
                                     ": it holds a film already (name a new folder)");
        check_writable(command.record / "000001.png");
    }
    if (command.benchmark && app.count("--warmup") == 0) command.warmup = 960;
    // Outputs that are written after the last frame need one.
    if (!command.frames && (command.reproducible() || command.benchmark)) command.frames = 300;
    return command;
}
