// Of the scene that the command line names, writes the first picture to the file of --dump: which
// names does a program understand? For build.sh, which runs it where Windows is none but Wine.
#include <iostream>

#include "common/files.hpp"
#include "common/harness/options.hpp"
#include "common/harness/output.hpp"
#include "common/scene/scene.hpp"

int main(int argc, char** argv)
try {
    const CommandLine command = parse_command_line(argc, argv,
                                                   {.name = "names",
                                                    .idea = "names of files",
                                                    .minimum_gl = 1.5,
                                                    .variants = {{"only", nullptr}},
                                                    .has_scene = true});
    const Scene scene = load_scene(command.scene, command.up);
    write_file(command.dump, read_file(scene.submeshes.at(0).material.picture));
} catch (const std::exception& failure) {
    std::cerr << "error: " << failure.what() << std::endl;
    return 1;
}
