#include "common/options.hpp"

#include <CLI/CLI.hpp>
#include <bit>
#include <cstdlib>
#include <iostream>
#include <sstream>

#include "common/files.hpp"

namespace {

constexpr int largest_window = 16384;

std::string parameters_help(Options options)
{
    options.weather = snow::make_weather("snow", 0, 0);
    std::ostringstream text;
    text << "For --set NAME=VALUE (value here: in snow):\n";
    for (const snow::Parameter& parameter : options.parameters()) {
        text << "  " << parameter.name << std::string(14 - std::string(parameter.name).size(), ' ')
             << *parameter.value << " " << parameter.unit << ", " << parameter.meaning << "\n";
    }
    return text.str();
}

// Changes the one parameter that `setting`, "name=value", names. Throws CLI::ValidationError.
void apply_setting(const std::string& setting, Options& options)
{
    const size_t equals = setting.find('=');
    const std::string name = setting.substr(0, equals);
    for (const snow::Parameter& parameter : options.parameters()) {
        if (name != parameter.name) continue;
        float value = 0;
        const bool number = equals != std::string::npos &&
                            CLI::detail::lexical_cast(setting.substr(equals + 1), value);
        // Written this way round, the comparison turns NaN away too.
        if (!number || !(value >= parameter.least && value <= parameter.most)) {
            std::ostringstream range;
            range << name << " takes " << parameter.least << " to " << parameter.most << " "
                  << parameter.unit << ", not '" << setting << "'";
            throw CLI::ValidationError("--set", range.str());
        }
        *parameter.value = value;
        return;
    }
    throw CLI::ValidationError("--set", "no parameter is called '" + name + "', see --help");
}

glm::ivec2 parse_size(const std::string& text)
{
    glm::ivec2 size{};
    char x = 0, rest = 0;
    std::istringstream in(text);
    const bool well_formed = in >> size.x >> x >> size.y && x == 'x' && !(in >> rest);
    if (!well_formed || size.x < 1 || size.y < 1 || size.x > largest_window ||
        size.y > largest_window) {
        throw CLI::ValidationError("--size",
                                   "takes WIDTHxHEIGHT of 1 to 16384 pixels, not '" + text + "'");
    }
    return size;
}

// AZIMUTH,ELEVATION,DISTANCE: degrees, degrees and m, within what the mouse can do.
void place_camera(const std::string& text, Camera& camera)
{
    float azimuth = 0, elevation = 0, distance = 0;
    char comma[2] = {}, rest = 0;
    std::istringstream in(text);
    const bool well_formed = in >> azimuth >> comma[0] >> elevation >> comma[1] >> distance &&
                             !(in >> rest) && comma[0] == ',' && comma[1] == ',';
    if (!well_formed || std::abs(azimuth) > 360 || elevation < -2 || elevation > 85 ||
        distance < 0.5f || distance > 80) {
        throw CLI::ValidationError("--camera",
                                   "takes AZIMUTH,ELEVATION,DISTANCE of -360 to 360 degrees, -2 to "
                                   "85 degrees and 0.5 to 80 m, not '" +
                                       text + "'");
    }
    camera.azimuth = glm::radians(azimuth);
    camera.elevation = glm::radians(elevation);
    camera.distance = distance;
}

}  // namespace

std::string keys_help(const Step& step)
{
    std::string help = "Mouse: drag to orbit, wheel to zoom. C: camera back. T: tour. H: panel.\n"
                       "Space: pause. R: restart. S: screenshot. Escape: quit.";
    for (const Setting& setting : step.settings) {
        if (setting.key != 0) help += std::string(" ") + setting.key + ": " + setting.name + ".";
    }
    return help;
}

std::vector<snow::Parameter> Options::parameters()
{
    std::vector<snow::Parameter> all = snow::weather_parameters(weather);
    for (Setting& s : step.settings) {
        all.push_back({s.name, s.unit, s.least, s.most, s.meaning, &s.value});
    }
    return all;
}

float Options::setting(std::string_view name) const
{
    for (const Setting& s : step.settings) {
        if (s.name == name) return s.value;
    }
    throw std::logic_error(step.name + " has no setting named " + std::string(name));
}

Options parse_options(int argc, char** argv, Step step)
{
    Options options;
    options.step = std::move(step);
    options.variant = options.step.variants.front();
    unsigned particles = 20000, seed = 1;
    std::string preset = "snow", up = "y", size = "1280x720", camera;
    std::vector<std::string> settings;

    CLI::App app(options.step.name + ": " + options.step.idea);
    app.add_option("--particles", particles, "flakes in the pool (20000)")
        ->check(CLI::Range(0u, snow::max_particles));
    app.add_option("--variant", options.variant, "way of doing it (" + options.variant + ")")
        ->check(CLI::IsMember(options.step.variants));
    app.add_option("--weather", preset, "kind of weather (snow)")
        ->check(CLI::IsMember({"snow", "rain", "hail"}));
    app.add_option("--set", settings,
                   "NAME=VALUE, a number of the weather or of the step (list below)")
        ->allow_extra_args(false);
    if (options.step.has_scene) {
        app.add_option("--scene", options.scene,
                       "OBJ file to snow on, or none (the built-in courtyard)");
        app.add_option("--up", up, "axis that points up in that file (y)")
            ->check(CLI::IsMember({"y", "z"}));
        app.add_option("--voxels", options.voxels, "voxels along the scene's longest axis (256)")
            ->check([](const std::string& text) {
                int n = 0;
                const bool fits = CLI::detail::lexical_cast(text, n) && n >= 32 && n <= 1024;
                return fits && std::has_single_bit(static_cast<unsigned>(n))
                           ? std::string()
                           : "takes a power of two from 32 (one word of bits) to 1024 (128 MiB), "
                             "not " +
                                 text;
            });
    }
    if (options.step.fixed_points) {
        app.add_option("--groups", options.groups, "pieces in which the pool is drawn (2)")
            ->check(CLI::Range(1u, 1000000u));
        app.add_option("--point-size", options.point_size,
                       "pixels of emitter 0's points, half of emitter 1's (1)")
            ->check(CLI::Range(0.1, 64.0));
    }
    for (const Setting& setting : options.step.settings) {
        if (setting.name != std::string("hold_fps")) continue;
        app.add_option_function<std::string>(
            "--hold-fps",
            [&settings](const std::string& fps) { settings.push_back("hold_fps=" + fps); },
            "frame rate to hold by moving fewer flakes");
    }
    app.add_option("--seed", seed, "another seed, another snowfall (1)");
    app.add_option("--size", size, "window, WIDTHxHEIGHT in pixels (1280x720)");
    app.add_option("--camera", camera,
                   "AZIMUTH,ELEVATION,DISTANCE from the middle, degrees and m (41,15,17.5)");
    app.add_flag("--tour", options.tour, "fly the camera through the courtyard, round and round");
    CLI::Option* vsync = app.add_flag("--vsync", options.vsync,
                                      "wait for the display (off, so that times can be compared)");
    app.add_option("--frames", options.frames, "stop after so many frames (run until closed)");
    app.add_option("--warmup", options.warmup, "frames to run before the first that counts (0)");
    app.add_option("--timelapse", options.timelapse, "how many times as fast it snows (1)")
        ->check(CLI::Range(1u, 1000u));
    app.add_flag(
           "--benchmark", options.benchmark,
           "measure: panel hidden, 720 frames of warm-up (until all snow is out), 300 counted")
        ->excludes(vsync);
    app.add_option("--csv", options.csv, "write the times of every frame to this file");
    app.add_flag("--realtime", options.realtime,
                 "follow the clock even with --frames, --dump or --screenshot (one step a frame)");
    app.add_option("--record", options.record, "write every frame to a PNG file in this folder");
    app.add_option("--screenshot", options.screenshot, "write the last frame to this PNG file");
    app.add_option("--dump", options.dump,
                   "write all flakes to this CSV file after the last frame");
    if (options.step.has_cover) {
        app.add_option("--dump-cover", options.dump_cover,
                       "write the mass of lying snow, cell by cell, to this CSV file");
    }
    app.add_flag("--debug", options.debug, "OpenGL debug context, messages to stderr");
    app.footer(parameters_help(options) + "\n" + keys_help(options.step) + "\n");

    try {
        app.parse(argc, argv);
        options.size = parse_size(size);
        if (!camera.empty()) place_camera(camera, options.camera);
        options.weather = snow::make_weather(preset, particles, seed);
        for (const std::string& setting : settings) apply_setting(setting, options);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        std::exit(0);
    } catch (const CLI::ParseError& error) {
        std::cerr << options.step.name << ": " << error.what() << " (try --help)\n";
        std::exit(2);
    }
    options.up = up.front();
    if (options.step.has_scene && options.scene.empty()) {
        options.scene = find_file("common/assets/courtyard.obj");
    }
    for (const auto& output : {options.screenshot, options.dump, options.dump_cover, options.csv}) {
        if (!output.empty()) check_writable(output);
    }
    if (!options.record.empty()) {
        std::error_code error;  // is shown by what follows
        std::filesystem::create_directories(options.record, error);
        check_writable(options.record / "000001.png");
    }
    if (options.benchmark && app.count("--warmup") == 0) options.warmup = 720;
    // What is to be written after the last frame needs a last frame.
    if (!options.frames && options.reproducible()) options.frames = 300;
    return options;
}
