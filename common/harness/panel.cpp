#include "common/harness/panel.hpp"

#include <GL/glew.h>
#include <GL/freeglut.h>

#include <algorithm>
#include <cfloat>
#include <imgui.h>
#include <imgui_impl_glut.h>
#include <imgui_impl_opengl2.h>

namespace {

void draw_times(const std::deque<FrameTime>& frames)
{
    std::vector<double> times;
    for (const FrameTime& frame : frames) times.push_back(frame.frame_ms);
    const std::vector<float> plot(times.begin(), times.end());
    const double median = quantile(times, 0.5), p95 = quantile(times, 0.95);
    ImGui::Text("%.2f ms a frame (%.0f fps), p95 %.2f ms", median, 1000 / std::max(median, 1e-3),
                p95);
    ImGui::PlotLines("##frames", plot.data(), int(plot.size()), 0, nullptr, 0,
                     float(std::max(2 * median, p95)),
                     ImVec2(ImGui::GetContentRegionAvail().x, 4 * ImGui::GetFontSize()));
    if (frames.empty()) return;
    const size_t behind = std::min<size_t>(frames.size(), 8);  // its GPU times have arrived by now
    for (const auto& [name, cpu_ms, gpu_ms, queries] : frames[frames.size() - behind].stages)
        ImGui::Text("%-10s cpu %6.2f  gpu %6.2f ms", name.c_str(), cpu_ms, gpu_ms.value_or(0));
}

// A slider, or a check box for a switch.
void draw_parameter(const snow::Parameter& parameter)
{
    if (parameter.is_switch()) {
        ImGui::Checkbox(parameter.label, std::get<bool*>(parameter.value));
    } else {
        char format[32];
        std::snprintf(format, sizeof format, "%%.3g %s", parameter.unit);
        ImGui::SliderFloat(parameter.label, std::get<float*>(parameter.value), parameter.minimum,
                           parameter.maximum, format,
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("%s\n--set %s=%g", parameter.meaning, parameter.name,
                          double(parameter.get()));
    }
}

// All of them, those of a heading together below it. It unfolds when it is clicked.
void draw_parameters(const std::vector<snow::Parameter>& parameters)
{
    std::vector<std::string_view> headings;  // in the order in which they first come
    for (const snow::Parameter& parameter : parameters) {
        if (std::find(headings.begin(), headings.end(), parameter.heading) == headings.end())
            headings.push_back(parameter.heading);
    }
    ImGui::PushItemWidth(0.5f * ImGui::GetWindowWidth());
    for (const std::string_view heading : headings) {
        if (!heading.empty() && !ImGui::CollapsingHeader(heading.data())) continue;
        for (const snow::Parameter& parameter : parameters) {
            if (parameter.heading == heading) draw_parameter(parameter);
        }
    }
    ImGui::PopItemWidth();
}

}  // namespace

Panel::Panel()
{
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // no file is left behind
    // Twice as large on a screen with twice the rows, or it could not be read there.
    const float scale = float(std::max(1, glutGet(GLUT_SCREEN_HEIGHT) / 1080));
    ImFontConfig font;
    font.SizePixels = 13 * scale;
    ImGui::GetIO().Fonts->AddFontDefault(&font);
    ImGui::GetStyle().ScaleAllSizes(scale);
    ImGui_ImplGLUT_Init();
    ImGui_ImplOpenGL2_Init();
    // When it is hidden, too, or it would take a key for one held down that was let go meanwhile.
    glutKeyboardUpFunc(ImGui_ImplGLUT_KeyboardUpFunc);
}

Panel::~Panel()
{
    ImGui_ImplOpenGL2_Shutdown();
    ImGui_ImplGLUT_Shutdown();
    ImGui::DestroyContext();
}

void Panel::draw(glm::ivec2 size, CommandLine& command, Controls& controls,
                 const std::deque<FrameTime>& frames, const std::string& renderer)
{
    ImGui::GetIO().DisplaySize = ImVec2(float(size.x), float(size.y));
    ImGui_ImplOpenGL2_NewFrame();
    const int frame = ImGui::GetFrameCount();
    ImGui_ImplGLUT_NewFrame();
    if (ImGui::GetFrameCount() == frame) ImGui::NewFrame();  // up to 1.89.5 the line above did it
    lay_out_panel(command, controls, frames, renderer);
    ImGui::Render();

    // The panel is drawn with fixed functions: nothing of the step's own may be bound.
    if (GLEW_VERSION_3_0) glBindVertexArray(0);
    if (GLEW_VERSION_2_0) glUseProgram(0);
    if (GLEW_VERSION_1_3) glActiveTexture(GL_TEXTURE0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
}

void lay_out_panel(CommandLine& command, Controls& controls, const std::deque<FrameTime>& frames,
                   const std::string& renderer)
{
    // In a corner, and no more than a third of the window: the wheel scrolls what has no room.
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float margin = 10, width = std::min(28 * ImGui::GetFontSize(), window.x - 2 * margin);
    ImGui::SetNextWindowPos(ImVec2(margin, margin), ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize(ImVec2(width, 0));  // 0: as high as what is unfolded
    const float room = std::min(window.y - 2 * margin, window.x * window.y / 3 / width);
    ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(FLT_MAX, std::max(room, 40.0f)));
    ImGui::Begin(command.lesson.name.c_str(), nullptr, ImGuiWindowFlags_NoResize);
    ImGui::TextWrapped("%s", renderer.c_str());
    draw_times(frames);
    if (!controls.note.empty()) ImGui::TextUnformatted(controls.note.c_str());

    ImGui::Separator();
    static int flakes = 0;  // as the slider stands; taken over when it is let go
    if (!ImGui::IsAnyItemActive()) flakes = int(command.weather.particles);
    ImGui::SliderInt("flakes", &flakes, 0, 10'000'000, "%d",
                     ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    if (ImGui::IsItemDeactivatedAfterEdit()) {
        command.weather.particles = unsigned(flakes);
        controls.restart = true;
    }
    int times = int(command.timelapse);
    ImGui::SliderInt("times as fast", &times, 1, 100, "%d", ImGuiSliderFlags_AlwaysClamp);
    command.timelapse = unsigned(times);
    const std::vector<Variant>& variants = command.lesson.variants;
    for (const Variant& variant : variants) {
        if (ImGui::RadioButton(variant.name.c_str(), variant.name == command.variant)) {
            command.variant = variant.name;
            controls.restart = true;
        }
        if (&variant != &variants.back()) ImGui::SameLine();
    }
    const std::vector<snow::Parameter> parameters = command.parameters();
    draw_parameters(parameters);

    ImGui::Separator();
    ImGui::Checkbox("pause", &controls.paused);
    ImGui::SameLine();
    controls.single_step |= ImGui::Button("single step");
    ImGui::SameLine();
    const std::pair<const char*, unsigned char> buttons[] = {
        {"restart", 'r'},     {"screenshot", 's'}, {"tour", 't'},
        {"camera back", 'c'}, {"hide", 'h'},       {"quit", escape_key}};
    for (const auto& [label, key] : buttons) {
        if (ImGui::Button(label)) controls.key = key;
        if (key == 's' || key == 't' || key == 'h') ImGui::SameLine();
    }
    ImGui::NewLine();
    ImGui::TextWrapped("%s", keys_help(parameters).c_str());
    ImGui::End();
}

bool Panel::press_key(unsigned char key, int x, int y)
{
    ImGui_ImplGLUT_KeyboardFunc(key, x, y);
    return ImGui::GetIO().WantTextInput;  // a number is being typed into a slider
}

bool Panel::press_special_key(int key, bool down, int x, int y)
{
    (down ? ImGui_ImplGLUT_SpecialFunc : ImGui_ImplGLUT_SpecialUpFunc)(key, x, y);
    return ImGui::GetIO().WantTextInput;
}

bool Panel::press_button(int button, int state, int x, int y)
{
    const int notches = wheel_notches(button);
    if (notches == 0)
        ImGui_ImplGLUT_MouseFunc(button, state, x, y);
    else if (state == GLUT_DOWN)
        ImGui_ImplGLUT_MouseWheelFunc(0, notches, x, y);
#if IMGUI_VERSION_NUM < 18700  // from then on its GLUT backend sees to this
    ImGui::GetIO().KeyCtrl = (glutGetModifiers() & GLUT_ACTIVE_CTRL) != 0;
#endif
    return ImGui::GetIO().WantCaptureMouse;
}

void Panel::move_mouse(int x, int y)
{
    ImGui_ImplGLUT_MotionFunc(x, y);
}

void Panel::let_go()
{
    ImGui::GetIO().MouseDown[0] = false;
}
