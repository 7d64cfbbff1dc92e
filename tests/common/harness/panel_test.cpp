// The panel's contents, laid out for no window at all.
#include "common/harness/panel.hpp"

#include <gtest/gtest.h>
#include <imgui.h>

namespace {

bool a_switch = true;
float a_number = 5;

// The panel on a screen of that size, pixels, with all its headings unfolded.
class PanelOnScreen {
public:
    explicit PanelOnScreen(ImVec2 screen)
    {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = screen;
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
        command.lesson.name = "panel";
        command.lesson.variants = {
            {"fancy",
             nullptr,
             {{"a_switch", "a switch", "on/off", 0, 1, "a test", &a_switch, 'W', "Own"},
              {"a_number", "a number", "m", 0, 10, "a test", &a_number, 0, "Own"}}}};
        command.variant = "fancy";
        command.weather = snow::make_weather("snow", 100, 1);
        controls.note = "a note";
        for (int frame = 0; frame < 4; ++frame) draw();  // its size follows from the frames before
    }
    ~PanelOnScreen() { ImGui::DestroyContext(); }

    void draw()
    {
        ImGui::NewFrame();
        lay_out_panel(command, controls, {{10, false, {{"update", 2, 3.0}}}}, "no renderer");
        ImGui::Begin("panel");
        size = ImGui::GetWindowSize();
        for (const snow::Parameter& parameter : command.parameters())
            ImGui::GetStateStorage()->SetInt(ImGui::GetID(parameter.heading), true);
        ImGui::End();
        ImGui::Render();
    }

    CommandLine command;
    Controls controls;
    ImVec2 size;
};

const ImVec2 large(2000, 2000);

}  // namespace

TEST(Panel, LeavesTwoThirdsOfTheWindowToThePicture)
{
    for (const ImVec2 screen : {ImVec2(1280, 720), ImVec2(400, 700), ImVec2(640, 480), large}) {
        const ImVec2 panel = PanelOnScreen(screen).size;
        EXPECT_LE(panel.x * panel.y, screen.x * screen.y / 3) << screen.x << " x " << screen.y;
        EXPECT_LT(panel.x, screen.x);
        EXPECT_LT(panel.y, screen.y);
    }
}

// With Ctrl and a click a number can be typed into a slider: here into each, from top to bottom.
TEST(Panel, SlidersTakeNoNumberBeyondTheirEnds)
{
    PanelOnScreen panel(large);
    ImGuiIO& io = ImGui::GetIO();
    const auto use_mouse = [&](bool down, bool control) {
        io.MouseDown[0] = down;
        io.KeyCtrl = control;
        panel.draw();
    };
    for (float y = 10; y < 10 + panel.size.y; y += 6) {
        io.MousePos = ImVec2(80, y);
        use_mouse(false, true);
        use_mouse(true, true);
        use_mouse(false, false);
        if (io.WantTextInput) io.AddInputCharactersUTF8("1e9");
        panel.draw();
        io.MousePos = ImVec2(1900, 1900);  // and elsewhere: the number is taken
        use_mouse(true, false);
        use_mouse(false, false);
    }
    int at_their_ends = 0;
    for (const snow::Parameter& parameter : panel.command.parameters()) {
        EXPECT_GE(parameter.get(), parameter.minimum) << parameter.name;
        EXPECT_LE(parameter.get(), parameter.maximum) << parameter.name;
        at_their_ends += !parameter.is_switch() && parameter.get() == parameter.maximum;
    }
    EXPECT_GE(at_their_ends, 10);
    EXPECT_LE(panel.command.weather.particles, 10'000'000u);
}
