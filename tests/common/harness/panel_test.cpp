// The panel's contents, laid out for no window at all.
#include "common/harness/panel.hpp"

#include <gtest/gtest.h>
#include <imgui.h>

namespace {

bool a_switch = true;
float a_number = 5;

std::vector<snow::Parameter> own_parameters()
{
    return {{"a_switch", "a switch", "on/off", 0, 1, "a test", &a_switch, 'W', "Own"},
            {"a_number", "a number", "m", 0, 10, "a test", &a_number, 0, "Own"}};
}

// What there is on a screen of that size, pixels, for a variant of two.
ImVec2 size_for(const char* variant, ImVec2 screen, bool unfolded)
{
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = screen;
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);

    CommandLine command;
    command.lesson.name = "panel";
    command.lesson.variants = {{"plain", nullptr}, {"fancy", nullptr, own_parameters()}};
    command.variant = variant;
    command.weather = snow::make_weather("snow", 100, 1);
    Controls controls;
    controls.note = "a note";
    const std::deque<FrameTime> frames = {{10, false, {{"update", 2, 3.0}}}};
    ImVec2 result;
    for (int frame = 0; frame < 4; ++frame) {  // its size follows from the frames before
        ImGui::NewFrame();
        lay_out_panel(command, controls, frames, "no renderer");
        ImGui::Begin("panel");
        result = ImGui::GetWindowSize();
        for (const snow::Parameter& parameter : command.parameters())
            ImGui::GetStateStorage()->SetInt(ImGui::GetID(parameter.heading), unfolded);
        ImGui::End();
        ImGui::Render();
    }
    ImGui::DestroyContext();
    EXPECT_FALSE(controls.restart);
    EXPECT_EQ(command.weather.particles, 100u);
    return result;
}

const ImVec2 large(2000, 2000);

}  // namespace

TEST(Panel, HasAWidgetForEveryParameterOfTheVariant)
{
    const float folded = size_for("plain", large, false).y;
    const float plain = size_for("plain", large, true).y, fancy = size_for("fancy", large, true).y;
    EXPECT_GT(plain, folded + 15 * 13) << "a line, 13 pixels, for each number of the weather";
    EXPECT_GT(fancy, plain + 3 * 13) << "and for a heading and what stands below it";
}

TEST(Panel, LeavesTwoThirdsOfTheWindowToThePicture)
{
    for (const ImVec2 screen : {ImVec2(1280, 720), ImVec2(400, 700), ImVec2(640, 480), large}) {
        const ImVec2 panel = size_for("fancy", screen, true);
        EXPECT_LE(panel.x * panel.y, screen.x * screen.y / 3) << screen.x << " x " << screen.y;
        EXPECT_LT(panel.x, screen.x);
        EXPECT_LT(panel.y, screen.y);
    }
}
