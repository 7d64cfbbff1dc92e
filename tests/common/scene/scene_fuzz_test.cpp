// Scenes spoilt at random: whatever is in a file, it is drawn well or refused in a line.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/common/scene/fuzz/scene_input.hpp"

using namespace std::literals;

namespace {

const std::string seeds[] = {
    "mtllib m.mtl\nv -8 0 -8\nv -8 0 8\nv 8 0 8\nv 8 0 -8\nusemtl a\nf 1 2 3 4\nusemtl b\n"
    "v 0 1 0\nv 1 1e0 0 0.5 1 0.25\nv 0 2 0 1.0\nf -1//1 -2/2/ -3 # a lamp\nf 1 5 2 \\\n6\n" +
        "\0newmtl a\nKd 0.5 0.25 1\nmap_Kd -s 1 2 m.mtl\nmap_d a.png\nnewmtl b\nKd 0 0 0\nKe 1 2 3\n"s,
    "mtllib m.mtl\nv -8 0 -8\nv -8 0 8\nv 8 0 8\nv 8 0 -8\nvt 0 0\nvt 1 0.5\nvn 0 1 0\ns 1\nusemtl "
    "a\n"
    "f 1/1/1 2/2/1 3/-1/-1 4/1\nv 0 1 0\nf 1/1 2/2 5/1\ns off\nf 2/1//1 3 5//1\n\0newmtl a\nmap_Kd -o 1 m.mtl\n"s,
    "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nv 0 0 1\r\nv 1 0 1\r\nv 1 1 1\r\nv 0 1 1\r\n"
    "f 4 3 2 1\r\nf 5 6 7 8\r\nf 1 2 6 5\r\nf 2 3 7 6\r\nf 3 4 8 7\r\nf 4 1 5 8\r\n",
    "v 691500.4 300 5336200\rv 691501.2 300 5336200\rv 691501.2 301.5 5336206\rf 1 2 3\r"};

const std::string_view pieces[] = {
    "vt ",   "vn ",    "s ",   "map_Kd ", "map_d ",     "-s ",          "//",
    "v ",    "f ",     "\n",   "\r",      " ",          "\\\n",         "#",
    "/",     "-",      "1",    "9",       "4294967296", "1e38",         "1e-38",
    "1e308", "1e-320", "nan",  "inf",     "mtllib ",    "usemtl ",      "newmtl ",
    "Kd ",   "Ke ",    "1e39", "m.mtl",   "/dev/zero",  "\xEF\xBB\xBF", "\0"sv};

}  // namespace

TEST(SpoiltScene, IsDrawnWellOrRefusedInALine)
{
    const SceneInput input;
    std::mt19937 random(1);
    const auto below = [&](size_t end) { return size_t(random() % end); };
    for (int round = 0; round < 5000; ++round) {
        std::string bytes = seeds[below(std::size(seeds))];
        for (size_t changes = 1 + below(6); changes > 0 && !bytes.empty(); --changes) {
            const size_t place = below(bytes.size()), length = below(8);
            switch (below(4)) {
            case 0:
                bytes[place] = char(below(256));
                break;
            case 1:
                bytes.erase(place, length);
                break;
            case 2:
                bytes.insert(place, pieces[below(std::size(pieces))]);
                break;
            case 3:
                bytes.insert(below(bytes.size()), bytes.substr(place, 4 * length));
                break;
            }
        }
        input.load(bytes);
    }
}
