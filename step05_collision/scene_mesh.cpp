#include "step05_collision/scene_mesh.hpp"

#include <cstddef>

SceneMesh::SceneMesh(const Scene& scene)
    : vertices_(make_buffer()), indices_(make_buffer()), vao_(make_vertex_array()),
      count_(GLsizei(scene.indices.size()))
{
    const auto vertex_bytes = GLsizeiptr(scene.vertices.size() * sizeof(Vertex));
    const auto index_bytes = GLsizeiptr(scene.indices.size() * sizeof(uint32_t));
    glBindVertexArray(vao_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER, vertex_bytes, scene.vertices.data(), GL_STATIC_DRAW);
    // The vertex array remembers this one, as it does the attributes.
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, index_bytes, scene.indices.data(), GL_STATIC_DRAW);
    check_memory("the scene", double(vertex_bytes + index_bytes));
    const auto field = [](GLuint location, GLint floats, size_t offset) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, floats, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                              reinterpret_cast<const void*>(offset));
    };
    field(0, 3, offsetof(Vertex, position));
    field(1, 3, offsetof(Vertex, normal));
    field(2, 3, offsetof(Vertex, colour));
    field(3, 2, offsetof(Vertex, uv));
}

void SceneMesh::draw() const
{
    glBindVertexArray(vao_);
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
}

void SceneMesh::draw(const Submesh& submesh) const
{
    glBindVertexArray(vao_);
    glDrawElements(GL_TRIANGLES, GLsizei(submesh.count), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(submesh.first * sizeof(uint32_t)));
}
