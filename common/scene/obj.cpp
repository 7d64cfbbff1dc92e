#include "common/scene/obj.hpp"

#include <charconv>
#include <optional>
#include <utility>

namespace fs = std::filesystem;

namespace {

class Reader {
public:
    explicit Reader(const fs::path& path) : path_(path), obj_{{}, {}, {}, Materials(path)} {}

    Obj read() &&
    {
        Statements statements(path_);
        size_t material = 0;
        while (const std::optional<Statement> statement = statements.next()) {
            line_ = statement->line;
            if (statement->keyword == "v") {
                read_point(without_comment(statement->rest));
            } else if (statement->keyword == "f") {
                read_polygon(without_comment(statement->rest), material);
            } else if (statement->keyword == "usemtl") {
                material = obj_.materials.find(*statement);
            } else if (statement->keyword == "mtllib") {
                obj_.materials.read(*statement);
            }
        }
        check_corners();
        return std::move(obj_);
    }

private:
    [[noreturn]] void refuse(const std::string& reason) const
    {
        refuse_scene(path_, "line " + std::to_string(line_) + ": " + reason);
    }

    // x y z, x y z w, or x y z red green blue
    void read_point(std::string_view words)
    {
        double numbers[6];
        int count = 0;
        for (; count < 6 && !words.empty(); ++count) {
            const std::string_view word = take_word(words);
            const std::optional<double> number = to_number(word);
            if (!number && count < 3) refuse(quoted(word) + " is no coordinate");
            numbers[count] = number.value_or(0);
        }
        if (count < 3) refuse(std::to_string(count) + " coordinates, at least 3 are needed");
        obj_.points.emplace_back(numbers[0], numbers[1], numbers[2]);
        glm::vec3 colour = Material{}.colour;
        if (count == 6)
            colour = glm::clamp(glm::dvec3(numbers[3], numbers[4], numbers[5]), 0.0, 1.0);
        obj_.colours.push_back(colour);
    }

    void read_polygon(std::string_view words, size_t material)
    {
        Polygon polygon{{}, material};
        while (!words.empty()) polygon.corners.push_back(to_corner(take_word(words)));
        const size_t count = polygon.corners.size();
        if (count < 3) refuse(std::to_string(count) + " corners, at least 3 are needed");
        constexpr size_t most = 10000;  // or the time to cut it into triangles would show
        if (count > most) {
            refuse(std::to_string(count) + " corners, at most " + std::to_string(most) +
                   " can be read (divide the face)");
        }
        obj_.polygons.push_back(std::move(polygon));
        lines_.push_back(line_);
    }

    // A point, counted from 1, or backwards from the last; texture coordinates and normals may
    // follow behind slashes.
    uint32_t to_corner(std::string_view word) const
    {
        int64_t point = 0;
        const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), point);
        const std::string_view rest = word.substr(size_t(stop - word.data()));
        if (error == std::errc::invalid_argument || (!rest.empty() && rest[0] != '/') ||
            rest.find_first_not_of("/-0123456789") != rest.npos) {
            refuse(quoted(word) + " is no corner");
        }
        if (point < 0) point += int64_t(obj_.points.size()) + 1;
        if (error != std::errc() || point < 1 || point > UINT32_MAX)
            refuse(quoted(word) + " is not one of the vertices, which are counted from 1");
        return uint32_t(point - 1);
    }

    // Points may come behind the polygons that they are corners of.
    void check_corners()
    {
        const size_t count = obj_.points.size();
        for (size_t i = 0; i < lines_.size(); ++i) {
            line_ = lines_[i];
            for (const uint32_t corner : obj_.polygons[i].corners) {
                if (corner < count) continue;
                refuse("there is no vertex " + std::to_string(corner + 1) + ", the last is " +
                       std::to_string(count));
            }
        }
    }

    fs::path path_;
    Obj obj_;
    int line_ = 0;
    std::vector<int> lines_;  // of the polygons
};

}  // namespace

Obj read_obj(const fs::path& path)
{
    return Reader(path).read();
}
