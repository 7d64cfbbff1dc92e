#include "step06_accumulation/winter/winter.hpp"

Winter::Computed::Computed(Window& window)
    : wind(window.shared<SolidScene>().grid), occlusion(window.shared<SolidScene>().grid)
{}

Winter::Winter(Window& window, const SolidScene& solid, const Columns& columns)
    : solid_(solid), columns_(columns), computed_(window.shared<Computed>()),
      live_(window.options().weather.particles), daylight_(solid),
      surface_(solid.drawn, solid.grid.cell_size)
{}

std::vector<snow::Parameter> Winter::parameters()
{
    std::vector<snow::Parameter> all;
    for (const auto& part :
         {snow::under("Surface", SnowSurface::parameters()), Columns::parameters(),
          snow::under("Flakes", Flakes::parameters()), snow::under("Wind", WindField::parameters()),
          snow::under("Light and air", Sky::parameters()),
          snow::under("Light and air", Daylight::parameters()),
          snow::under("Frame rate", FlakeBudget::parameters())}) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

void Winter::choose_flakes(Window& window, const PingPong& particles)
{
    budget_.frame(window.frame_seconds(), ticks_before_, FlakeBudget::hold_fps, FlakeBudget::live);
    window.note(budget_.report());
    live_.resize(budget_.share(), particles);
}

void Winter::set_wind(Program& program, const snow::Weather& weather) const
{
    computed_.wind.set(program, weather);
}

void Winter::draw(Window& window, unsigned tick, const PingPong& particles)
{
    const snow::Weather& weather = window.options().weather;
    ticks_before_ = window.ticks();
    camera_.update(window, tick);
    daylight_.update(weather, tick);
    if (Daylight::shadow != 0) {
        const auto stage = window.stage("shadow");
        shadow_map_.update(daylight_.light(), solid_.mesh, window.size());
    }
    const auto set_light = [this](Program& program) {
        program.use();
        program.set_texture("shadow_map", SHADOW_UNIT, GL_TEXTURE_2D, shadow_map_.texture());
        program.set_texture("sky_seen", SKY_SEEN_UNIT, GL_TEXTURE_3D,
                            computed_.occlusion.texture());
    };
    {
        const auto stage = window.stage("scene");
        for (Program* program : surface_.programs()) {
            set_light(*program);
            columns_.set_depth(*program);
        }
        surface_.draw(solid_.pictures);
    }
    if (Sky::sky != 0) {
        const auto stage = window.stage("sky");
        set_light(sky_.program);
        sky_.draw();
    }
    if (Daylight::lamp != 0) {
        const auto stage = window.stage("lamp");
        lamp_.draw(daylight_.light(), solid_);
    }
    if (WindField::arrows != 0) {
        const auto stage = window.stage("arrows");
        arrows_.draw(computed_.wind, solid_, weather, tick);
    }
    {
        const auto stage = window.stage("draw");
        set_light(flakes_.billboard);
        flakes_.use(window);
        glBindVertexArray(particles.vao());
        glEnable(GL_BLEND);
        glDepthMask(GL_FALSE);  // flakes hide behind the scene, not behind each other
        for (const Range& half : live_) glDrawArrays(GL_POINTS, half.first, half.count);
        glDepthMask(GL_TRUE);
        glDisable(GL_BLEND);
    }
}
