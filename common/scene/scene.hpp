// Scenes from OBJ files: fitted into the world, and drawn as one list of triangles.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "common/gl_object.hpp"

struct Vertex {
    glm::vec3 position;  // m, world space
    glm::vec3 normal;    // of its triangle
    glm::vec3 colour;    // diffuse, linear
};

struct Scene {
    std::vector<Vertex> vertices;  // three in a row make a triangle, counter-clockwise from outside
    std::vector<Vertex> lamps;     // those again that shine (Ke), in the colour of their light
};

// Reads `path` and scales the scene to fit a box 16 m wide and deep and 6 m high, below the clouds;
// its floor comes to lie on y = 0 and its middle on the y axis. Says by what factor. `up` is the
// axis, 'y' or 'z', that points up in the file. Polygons with more than three corners are divided;
// sheets face up and bodies outwards, whichever way the file has them; what has no colour is grey,
// and what gets lost of materials is told on stderr. The path "none" is the empty scene. Throws
// std::runtime_error naming file and line.
Scene load_scene(const std::filesystem::path& path, char up);

// Triangles of a scene on the GPU: attributes 0 to 2 are the fields of Vertex.
class SceneMesh {
public:
    explicit SceneMesh(const std::vector<Vertex>& vertices);
    void draw() const;

private:
    GlObject buffer_, vao_;
    GLsizei count_;
};
