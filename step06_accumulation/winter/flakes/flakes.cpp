#include "step06_accumulation/winter/flakes/flakes.hpp"

#include "step03_shader_points/load_texture.hpp"

Flakes::Flakes()
    : billboard({{GL_VERTEX_SHADER, "step06_accumulation/winter/flakes/flake.vert"},
                 {GL_GEOMETRY_SHADER, "step06_accumulation/winter/flakes/flake.geom"},
                 {GL_FRAGMENT_SHADER, "step06_accumulation/winter/flakes/flake.frag"}}),
      sprite_({{GL_VERTEX_SHADER, "step03_shader_points/flake.vert"},
               {GL_FRAGMENT_SHADER, "step03_shader_points/flake.frag"}}),
      crystals_(load_texture("step03_shader_points/snowflakes.png"))
{}

std::vector<snow::Parameter> Flakes::parameters()
{
    return {
        {"billboards", "crystals", "on/off", 0, 1, "flakes are crystals, drawn out along their way",
         &billboards},
        {"splashes", "splashes", "on/off", 0, 1, "of drops that reach the ground", &splashes},
    };
}

void Flakes::use(const Window& window)
{
    if (billboards != 0) {
        billboard.use();
        billboard.set("splashes", splashes != 0 ? 1 : 0);
        billboard.set_texture("crystals", CRYSTALS_UNIT, GL_TEXTURE_2D, crystals_);
    } else {
        sprite_.use();
        sprite_.set("view", window.view());
        sprite_.set("projection", window.projection());
        sprite_.set("window_height", float(window.size().y));
    }
}
