#include "step06_accumulation/winter/flakes/flakes.hpp"

#include <cmath>

#include "step03_shader_points/load_texture.hpp"

Flakes::Flakes()
    : billboard_({{GL_VERTEX_SHADER, "step06_accumulation/winter/flakes/flake.vert"},
                  {GL_GEOMETRY_SHADER, "step06_accumulation/winter/flakes/flake.geom"},
                  {GL_FRAGMENT_SHADER, "step06_accumulation/winter/flakes/flake.frag"}}),
      splash_({{GL_VERTEX_SHADER, "step06_accumulation/winter/flakes/flake.vert"},
               {GL_GEOMETRY_SHADER, "step06_accumulation/winter/flakes/splash.geom"},
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
        {"blur", "out of focus", "on/off", 0, 1, "flakes close to the camera are large and soft",
         &blur},
        {"sorted", "back to front", "on/off", 0, 1, "flakes close by hide those behind them",
         &sorted},
        {"colours", "colours", "", 0, 3,
         "of flakes: 0 their own, 1 by speed, 2 by age, 3 by emitter", &colours},
    };
}

void Flakes::draw(const Window& window, const UseProgram& use_lit,
                  const std::function<void()>& draw_points)
{
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);  // flakes hide behind the scene, not behind each other
    if (billboards) {
        const auto draw_with = [&](Permutations& all) {
            Program& program = use_lit(all);
            program.set("blur", blur ? 1 : 0);
            program.set("colours", int(std::lround(colours)));
            program.set_texture("crystals", CRYSTALS_UNIT, GL_TEXTURE_2D, crystals_);
            draw_points();
        };
        draw_with(billboard_);
        if (splashes && window.options().weather.kind == snow::rain_kind) draw_with(splash_);
    } else {
        sprite_.use();
        sprite_.set("view", window.view());
        sprite_.set("projection", window.projection());
        sprite_.set("window_height", float(window.size().y));
        draw_points();
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}
