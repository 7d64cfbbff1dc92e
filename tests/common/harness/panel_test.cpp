// The panel's contents, laid out for no window at all.
#include "common/harness/panel.hpp"

#include <gtest/gtest.h>
#include <imgui.h>

namespace {

float a_switch = 1, a_number = 5;

std::vector<snow::Parameter> own_parameters()
{
    return {{"a_switch", "on/off", 0, 1, "a test", &a_switch, 'W'},
            {"a_number", "m", 0, 10, "a test", &a_number}};
}

// Height of the panel for a variant of two, pixels.
float height_for(const char* variant)
{
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(400, 2000);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);

    CommandLine command;
    command.lesson = {.name = "panel",
                      .idea = "a test",
                      .minimum_gl = 1.5,
                      .variants = {{"plain", nullptr}, {"fancy", nullptr, own_parameters}}};
    command.variant = variant;
    command.weather = snow::make_weather("snow", 100, 1);
    Controls controls;
    controls.note = "a note";
    const std::deque<FrameTime> frames = {{10, false, {{"update", 2, 3.0}}}};
    float result = 0;
    for (int frame = 0; frame < 3; ++frame) {  // its size follows from the frame before
        ImGui::NewFrame();
        lay_out_panel(command, controls, frames, "no renderer");
        ImGui::Begin("panel");
        result = ImGui::GetWindowHeight();
        ImGui::End();
        ImGui::Render();
    }
    ImGui::DestroyContext();
    EXPECT_FALSE(controls.restart);
    EXPECT_EQ(command.weather.particles, 100u);
    return result;
}

}  // namespace

TEST(Panel, HasAWidgetForEveryParameterOfTheVariant)
{
    const float plain = height_for("plain"), fancy = height_for("fancy");
    EXPECT_GT(plain, 15 * 13) << "a line, 13 pixels, for each number of the weather";
    EXPECT_GT(fancy, plain + 2 * 13);
}
