#include "common/harness/options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <bit>
#include <cstdlib>
#include <iostream>
#include <sstream>

#include "common/harness/files.hpp"
#include "common/harness/text.hpp"

namespace {

constexpr int largest_window = 16384;

std::string parameters_help(CommandLine command)
{
    command.weather = snow::make_weather("snow", 0, 0);
    std::ostringstream text;
    text << "For --set NAME=VALUE (value here: in snow):\n";
    for (const snow::Parameter& parameter : command.parameters()) {
        text << "  " << parameter.name << std::string(14 - std::string(parameter.name).size(), ' ')
             << parameter.get() << " " << parameter.unit << ", " << parameter.meaning
             << (parameter.costly ? " (0 in software)" : "") << "\n";
    }
    return text.str();
}

// Changes the one parameter that `setting`, "name=value", names. Throws CLI::ValidationError.
void apply_setting(const std::string& setting, CommandLine& command)
{
    const size_t equals = setting.find('=');
    const std::string name = setting.substr(0, equals);
    for (const snow::Parameter& parameter : command.parameters()) {
        if (name != parameter.name) continue;
        const std::string text = equals == std::string::npos ? "" : setting.substr(equals + 1);
        char* end = nullptr;
        const float value = std::strtof(text.c_str(), &end);
        // Written this way round, the comparison turns NaN away too.
        if (text.empty() || *end != '\0' ||
            !(value >= parameter.minimum && value <= parameter.maximum) ||
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

bool has_parameter(CommandLine& command, std::string_view name)
{
    const std::vector<snow::Parameter> all = command.parameters();
    return std::any_of(all.begin(), all.end(),
                       [name](const snow::Parameter& one) { return one.name == name; });
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

// From its version 2.6 on CLI11 would fill the footer's lines anew, and run the table's together.
template <typename Formatter>
void keep_lines(Formatter& formatter)
{
    if constexpr (requires { formatter.enable_footer_formatting(false); })
        formatter.enable_footer_formatting(false);
}

std::string not_empty(const std::string& text)
{
    return text.empty() ? "must not be empty" : "";
}

// Every file can be written once, and a picture is a PNG.
void check_outputs(const CommandLine& command)
{
    const std::string extension = lower_case(command.screenshot.extension().string());
    if (!extension.empty() && extension != ".png") {
        throw CLI::ValidationError("--screenshot", "writes PNG files, not " + extension);
    }
    std::vector<std::filesystem::path> seen;
    for (const auto& output : {command.screenshot, command.dump, command.dump_cover, command.csv}) {
        if (output.empty()) continue;
        std::error_code error;  // is shown when it is opened
        const std::filesystem::path file =
            std::filesystem::weakly_canonical(std::filesystem::absolute(output), error);
        const bool is_device =
            std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error);
        if (std::find(seen.begin(), seen.end(), file) != seen.end() && !is_device) {
            throw CLI::ValidationError(output.string(), "is named for two outputs");
        }
        seen.push_back(file);
    }
}

// A film in a folder that has an old one would be mixed up with it.
void check_record_folder(const std::filesystem::path& folder)
{
    std::error_code error;  // is shown by what follows
    std::filesystem::create_directories(folder, error);
    check_writable(folder / "000001.png");
    if (std::filesystem::exists(folder / "000001.png")) {
        throw std::runtime_error("cannot record into " + folder.string() +
                                 ": it holds a film already (name a new folder)");
    }
}

// What has no ending is rather a name misspelt than a file that is missing.
void check_scene(const std::filesystem::path& scene)
{
    std::error_code error;  // whatever it is, the file is not there
    if (scene == "none" || scene.has_extension() || std::filesystem::exists(scene, error)) return;
    throw std::runtime_error("cannot read " + scene.string() +
                             ": no such file, nor one of the scenes courtyard, mountains and none");
}

void check_voxels(int voxels)
{
    const bool fits = voxels >= 32 && voxels <= 1024;
    if (fits && std::has_single_bit(unsigned(voxels))) return;
    throw CLI::ValidationError("--voxels", "takes a power of two from 32 (one word of bits) to "
                                           "1024 (128 MiB), not " +
                                               std::to_string(voxels));
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

// Seen from the mouth of their valley, through air with less snow in it than elsewhere.
void enter_mountains(CommandLine& command)
{
    command.scene = find_file("common/assets/mountains.obj");
    command.metres = true;
    command.weather.follow = 1;
    command.weather.snowfall *= 0.4f;
    place_camera("75,9,48", command.camera);
}

// Under those of a courtyard one would see the end of the snow from anywhere in a landscape.
void widen_clouds(snow::Weather& weather)
{
    for (snow::Emitter& cloud : weather.emitters) cloud.half_size.x = cloud.half_size.z = 20;
}

}  // namespace

std::string keys_help(const std::vector<snow::Parameter>& parameters)
{
    std::string help = "Mouse: drag to orbit, wheel to zoom. C: camera back. T: tour. H: panel.\n"
                       "Space: pause. R: restart. S: screenshot. Escape: quit.";
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
    std::string preset = "snow", up = "y", size = "1280x720", camera;
    std::vector<std::string> settings;
    bool follow = false;

    CLI::App app(lesson.name + ": " + lesson.idea);
    const auto add_path = [&app](const char* name, std::filesystem::path& path, const char* what) {
        app.add_option_function<std::string>(
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
        add_path(
            "--scene", command.scene,
            "OBJ file to snow on, or none, or one that is built in: courtyard, or mountains, with "
            "--metres, --follow, and less snow, or nobody would see them (courtyard)");
        add_path("--collision", command.collision,
                 "OBJ file to land on instead, in the scene's coordinates (the scene)");
        app.add_option("--up", up, "axis that points up in those files (y)")
            ->check(CLI::IsMember({"y", "z"}));
        app.add_flag(
            "--follow", follow,
            "keep the clouds above the camera, 40 m of them with --metres: it snows wherever "
            "that goes (they stay)");
        app.add_flag("--metres", command.metres,
                     "those files are in metres: keep their size, up to 2 km (fit it to 16 m)");
        app.add_option("--voxels", command.voxels, "voxels along the scene's longest axis (256)");
        app.add_option("--voxeliser", command.voxeliser, "where their grid is made (cpu)")
            ->check(CLI::IsMember({"cpu", "gpu"}));
    }
    if (lesson.fixed_points) {
        app.add_option("--groups", command.groups, "pieces in which the pool is drawn (2)")
            ->check(CLI::Range(1u, 1000000u));
        app.add_option("--point-size", command.point_size,
                       "pixels of emitter 0's points, half of emitter 1's (1)")
            ->check(CLI::Range(0.1, 64.0));
    }
    if (has_parameter(command, "hold_fps")) {
        app.add_option_function<std::string>(
            "--hold-fps",
            [&settings](const std::string& fps) { settings.push_back("hold_fps=" + fps); },
            "frame rate to hold by moving fewer flakes");
    }
    app.add_option("--seed", seed, "another seed, another snowfall (1)");
    app.add_option("--size", size, "window, WIDTHxHEIGHT in pixels (1280x720)");
    app.add_option("--camera", camera,
                   "AZIMUTH,ELEVATION,DISTANCE from the middle, degrees and m (41,15,17.5)");
    app.add_flag(
        "--tour", command.tour,
        "fly the camera through the courtyard, or around a scene in --metres, round and round");
    CLI::Option* vsync = app.add_flag("--vsync", command.vsync,
                                      "wait for the display (off, so that times can be compared)");
    app.add_option("--frames", command.frames, "stop after so many frames (run until closed)");
    app.add_option(
        "--warmup", command.warmup,
        "frames to run before the first that counts (0), all but some 60 of them in time "
        "lapse, as nobody times them");
    app.add_option("--timelapse", command.timelapse, "how many times as fast it snows (1)")
        ->check(CLI::Range(1u, 1000u));
    app.add_flag(
           "--benchmark", command.benchmark,
           "measure: panel hidden, --warmup 960 (until all snow is out), --frames 300, and in "
           "each that counts one time step")
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
    }
    app.add_flag("--debug", command.debug, "OpenGL debug context, messages to stderr");
    keep_lines(*app.get_formatter());
    app.footer(
        [&command] { return parameters_help(command) + "\n" + keys_help(command.parameters()); });

    // No option takes nothing: an unset variable in a script is a mistake, not a wish.
    for (CLI::Option* option : app.get_options()) {
        if (option->get_items_expected_max() > 0) option->check(not_empty, "");
    }
    try {
        app.parse(argc, argv);
        check_outputs(command);
        command.size = parse_size(size);
        check_voxels(command.voxels);
        command.weather = snow::make_weather(preset, particles, seed);
        if (command.scene == "mountains") enter_mountains(command);
        if (!camera.empty()) place_camera(camera, command.camera);
        if (follow) command.weather.follow = 1;
        if (command.metres && command.weather.follow != 0) widen_clouds(command.weather);
        for (const std::string& setting : settings) apply_setting(setting, command);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        std::exit(0);
    } catch (const CLI::ParseError& error) {
        std::cerr << lesson.name << ": " << error.what() << " (try --help)\n";
        std::exit(2);
    }
    command.up = up.front();
    if (lesson.has_scene && (command.scene.empty() || command.scene == "courtyard")) {
        command.scene = find_file("common/assets/courtyard.obj");
    }
    if (lesson.has_scene) check_scene(command.scene);
    for (const auto& output : {command.screenshot, command.dump, command.dump_cover, command.csv}) {
        if (!output.empty()) check_writable(output);
    }
    if (!command.record.empty()) check_record_folder(command.record);
    if (command.benchmark && app.count("--warmup") == 0) command.warmup = 960;
    // What is to be written after the last frame needs a last frame.
    if (!command.frames && (command.reproducible() || command.benchmark)) command.frames = 300;
    return command;
}
