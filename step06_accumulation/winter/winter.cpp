#include "step06_accumulation/winter/winter.hpp"

Winter::Winter(Window& window, const SolidScene& solid, const Columns& columns)
    : solid_(solid), columns_(columns), wind_(solid.grid), occlusion_(solid.grid),
      live_(window.options().weather.particles), daylight_(solid),
      smooth_snow_(columns, solid.grid.resolution), surface_(solid)
{}

std::vector<snow::Parameter> Winter::parameters()
{
    std::vector<snow::Parameter> all;
    for (const auto& part :
         {snow::under("Surface", SnowSurface::parameters()), Columns::parameters(),
          snow::under("Flakes", Flakes::parameters()), snow::under("Wind", WindField::parameters()),
          snow::under("Light and air", Sky::parameters()),
          snow::under("Light and air", Daylight::parameters()),
          snow::under("Light and air", ShadowMap::parameters()),
          snow::under("Picture", LinearFrame::parameters()),
          snow::under("Picture", Bloom::parameters()), snow::under("Picture", Tone::parameters()),
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

Program& Winter::use_in_wind(Permutations& all, const snow::Weather& weather) const
{
    return wind_.use(all, weather);
}

void Winter::draw(Window& window, unsigned tick, const PingPong& particles)
{
    const snow::Weather& weather = window.options().weather;
    ticks_before_ = window.ticks();
    camera_.update(window, tick);
    daylight_.update(weather, tick);
    if (Daylight::shadow) {
        const auto stage = window.stage("shadow");
        shadow_map_.update(daylight_.light(), solid_.mesh, window.size());
    }
    {
        const auto stage = window.stage("smooth");
        smooth_snow_.update(tick, window.ticks());
    }
    const auto use_lit = [this](Permutations& all) -> Program& {
        Program& program = all.with(daylight_.parts());
        program.use();
        program.set_texture("shadow_map", SHADOW_UNIT, GL_TEXTURE_2D, shadow_map_.texture());
        program.set_texture("sky_seen", SKY_SEEN_UNIT, GL_TEXTURE_3D, occlusion_.texture());
        return program;
    };
    const glm::vec3 without_sky(0.10f, 0.13f, 0.20f);
    frame_.begin(window.size(), without_sky);
    if (SnowSurface::scene) {
        const auto stage = window.stage("scene");
        surface_.draw(weather, solid_.pictures, use_lit, [this](Program& program) {
            columns_.set_depth(program);
            program.set_texture("snow", SNOW_UNIT, GL_TEXTURE_3D, smooth_snow_.texture());
        });
    }
    if (daylight_.light().lamp_is_on > 0 && SnowSurface::scene) {
        const auto stage = window.stage("lamp");
        lamp_.draw(daylight_.light(), solid_);
    }
    if (Sky::sky) {
        const auto stage = window.stage("sky");
        sky_.draw(daylight_.light());
    }
    if (WindField::arrows) {
        const auto stage = window.stage("arrows");
        arrows_.draw(wind_, solid_, weather, tick);
    }
    frame_.end_edges();
    if (daylight_.light().lamp_is_on > 0 && daylight_.light().extinction > 0) {
        const auto stage = window.stage("halo");
        frame_.detach_depth();
        lamp_.draw_halo(frame_.depth());
        frame_.attach_depth();
    }
    if (Flakes::sorted) {
        const auto stage = window.stage("sort");
        depth_order_.sort(particles, live_);
    }
    {
        const auto stage = window.stage("draw");
        glBindVertexArray(particles.vao());
        flakes_.draw(window, use_lit, [this] {
            if (Flakes::sorted) return depth_order_.draw();
            for (const Range& half : live_) glDrawArrays(GL_POINTS, half.first, half.count);
        });
    }
    if (Bloom::bloom > 0) {
        const auto stage = window.stage("bloom");
        bloom_.update(frame_);
    }
    {
        const auto stage = window.stage("tone");
        frame_.end();
        tone_.draw(frame_, Bloom::bloom > 0 ? &bloom_ : nullptr);
    }
}
