#include "common/scene/obj.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "common/harness/progress.hpp"

namespace fs = std::filesystem;

namespace {

class Reader {
public:
    explicit Reader(const fs::path& path) : path_(path), obj_{{}, {}, {}, {}, {}, Materials(path)}
    {}

    Obj read() &&
    {
        Statements statements(path_);
        Progress progress("reading the scene");
        Polygon polygon;  // what the next one will have but its corners
        while (const std::optional<Statement> statement = statements.next()) {
            line_ = statement->line;
            if (progress.due()) progress.report(statements.done());
            if (statement->keyword == "v") {
                read_point(without_comment(statement->rest));
            } else if (statement->keyword == "f") {
                read_polygon(without_comment(statement->rest), polygon);
            } else if (statement->keyword == "vt") {
                const glm::dvec3 uv = read_numbers(*statement, 1);
                obj_.uvs.emplace_back(glm::clamp(uv, -1e6, 1e6));
            } else if (statement->keyword == "vn") {
                const glm::dvec3 normal = read_numbers(*statement, 3);
                obj_.normals.emplace_back(glm::clamp(normal, -1e6, 1e6));
            } else if (statement->keyword == "s") {
                polygon.smoothing = to_group(without_comment(statement->rest));
            } else if (statement->keyword == "usemtl") {
                polygon.material = obj_.materials.find(*statement);
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

    // Up to three, of which `least` must be there: without them the scene still has its shape.
    glm::dvec3 read_numbers(const Statement& statement, int least)
    {
        std::string_view words = without_comment(statement.rest);
        glm::dvec3 numbers(0);
        int count = 0;
        for (; count < 3 && !words.empty(); ++count) {
            const std::optional<double> number = to_number(take_word(words));
            if (!number) break;
            numbers[count] = *number;
        }
        if (count >= least) return numbers;
        obj_.materials.warnings.add(path_, statement, "not as many numbers as it needs, 0 instead");
        return glm::dvec3(0);
    }

    // A number; 0 is "off".
    static uint32_t to_group(std::string_view words)
    {
        const std::string_view word = take_word(words);
        uint32_t group = 0;
        std::from_chars(word.data(), word.data() + word.size(), group);
        return lower_case(word) == "on" ? 1 : group;
    }

    void read_polygon(std::string_view words, Polygon polygon)
    {
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

    // A point, counted from 1, or backwards from the last; texture coordinates and a normal,
    // counted alike, may follow behind slashes.
    Corner to_corner(std::string_view word) const
    {
        int64_t point = 0;
        const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), point);
        std::string_view rest = word.substr(size_t(stop - word.data()));
        if (error == std::errc::invalid_argument || (!rest.empty() && rest[0] != '/') ||
            rest.find_first_not_of("/-0123456789") != rest.npos) {
            refuse(quoted(word) + " is no corner");
        }
        if (point < 0) point += int64_t(obj_.points.size()) + 1;
        if (error != std::errc() || point < 1 || point >= Corner::none)
            refuse(quoted(word) + " is not one of the vertices, which are counted from 1");
        const auto behind_slash = [&](size_t count) {
            rest.remove_prefix(std::min<size_t>(rest.size(), 1));
            int64_t number = 0;
            std::from_chars(rest.data(), rest.data() + rest.size(), number);
            rest.remove_prefix(std::min(rest.find('/'), rest.size()));
            if (number < 0) number += int64_t(count) + 1;
            return number < 1 || number >= Corner::none ? Corner::none : uint32_t(number - 1);
        };
        Corner corner{uint32_t(point - 1)};
        corner.uv = behind_slash(obj_.uvs.size());
        corner.normal = behind_slash(obj_.normals.size());
        return corner;
    }

    // Points may come behind the polygons that they are corners of. Without texture coordinates or
    // a normal there is still a corner.
    void check_corners()
    {
        const size_t count = obj_.points.size();
        for (size_t i = 0; i < lines_.size(); ++i) {
            line_ = lines_[i];
            for (Corner& corner : obj_.polygons[i].corners) {
                if (corner.uv >= obj_.uvs.size()) corner.uv = Corner::none;
                if (corner.normal >= obj_.normals.size()) corner.normal = Corner::none;
                if (corner.point < count) continue;
                refuse("there is no vertex " + std::to_string(corner.point + 1) + ", the last is " +
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
